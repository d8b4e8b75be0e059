// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Inverse: from a point in space to the picture positions that see it.
//
// A ray o(x, y) + t d(x, y) meets the point P where the part of P - o that is perpendicular to d
// vanishes: two equations for x and y, of which there may be none, one or several solutions. Each
// camera layer of a picture is such a function of the whole picture's x and y.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/picture.hpp"

namespace balcony::analyse {

using Imath::V2d;
using Imath::V3d;

/// A picture position whose ray meets a point.
struct Sighting {
    std::size_t point = 0;  ///< The index of the point among those asked for.
    std::size_t layer = 0;  ///< Which camera layer of the picture shows it, the back one 0.
    V2d position;           ///< In pixels, within [0, width) x [0, height).
    V3d origin;             ///< Where the ray starts, in the axes of the points.
    double distance = 0.0;  ///< Along the ray, in scene units; not negative.
    double miss = 0.0;      ///< How far from the point the ray passes, in scene units.
};

/// Finds points in a picture, or in that of one camera, of one size, at one time. Immutable, may be
/// shared by threads, cheap to copy.
///
/// A layer shows a point where it covers something and nothing in front of it covers all. A camera
/// whose rays depend linearly on the picture (pinhole, parallel, two-slit and push-broom cameras,
/// turned and shifted in any way) is solved in closed form. For any other the picture is divided
/// into patches, small enough for Newton's iteration to find its way in each, and a tree over their
/// rays says which of them can see a point. The division starts from cells of 1/96 of the longer
/// side of the part that has rays, each looked at in 9 places, and goes down to 1/16 pixel at
/// seams, folds and borders; a detail that falls between those places can be overlooked.
///
/// Where a whole line of the picture sees a point (a pole of a panorama), some positions on it are
/// found. A point at which all rays of a region start is not seen by them, and one that is no
/// number by none.
class Locator {
public:
    /// Width and height of the picture are in pixels and positive. Time as in the camera's
    /// formulas. Without axes, points are in those of the cameras, which must be the same for all.
    [[nodiscard]] static Result<Locator> make(const camera::Picture& picture, double width,
                                              double height, double time = 0.0,
                                              std::optional<Axes> axes = {});

    /// The axes that points are in.
    [[nodiscard]] Axes axes() const;
    /// The names of the picture's camera layers, from the back to the front; one of a camera.
    [[nodiscard]] std::vector<std::string> layers() const;

    /// All sightings of a point, from left to right.
    [[nodiscard]] std::vector<Sighting> locate(const V3d& point) const;
    /// Those of many points, which is faster: point by point, each from left to right.
    [[nodiscard]] std::vector<Sighting> locate(std::span<const V3d> points) const;

    /// Whether all layers are solved in closed form.
    [[nodiscard]] bool closed_form() const;
    /// Into how many patches the picture is divided, those of all layers together; none for a layer
    /// that is solved in closed form.
    [[nodiscard]] std::size_t patch_count() const;

private:
    class Index;
    explicit Locator(std::shared_ptr<const Index> index) : index_(std::move(index)) {}
    std::shared_ptr<const Index> index_;
};

}  // namespace balcony::analyse
