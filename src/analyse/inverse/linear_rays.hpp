// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Cameras that can be solved in closed form.

#include <optional>

#include "analyse/inverse/ray_patches.hpp"

namespace balcony::analyse {

/// A camera whose rays, written as the point where a ray crosses a plane and its slope relative to
/// the plane's normal, are both affine functions of the picture: the "general linear cameras" of Yu
/// and McMillan (2004), among them all pinhole, parallel, two-slit and push-broom cameras. A point
/// at the height h above the plane is visible where crossing + h slope is its foot: two linear
/// equations.
class LinearRays {
public:
    /// Succeeds if all rays of the survey fit to a few units in the last place.
    [[nodiscard]] static std::optional<LinearRays> fit(const Survey& survey);

    /// The unique position whose line contains the point, inside the picture or not; nothing if
    /// there is no unique one.
    [[nodiscard]] std::optional<V2d> place_of(const V3d& point) const;

private:
    LinearRays(const Ray& ray, const V2d& at, const V3d& normal);

    [[nodiscard]] bool fits(const Ray& ray, const V2d& at, double extent) const;

    V2d center_;
    V3d normal_;
    double height_;
    V3d foot_, foot_by_x_, foot_by_y_;     ///< The point where a ray crosses the plane.
    V3d slope_, slope_by_x_, slope_by_y_;  ///< Its direction, scaled to 1 along the normal.
};

}  // namespace balcony::analyse
