// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The first-order map from the picture to the visible points.

#include <optional>

#include "analyse/measure/ray_field.hpp"

namespace balcony::analyse {

/// The motion, seen along the ray, of the point at a distance when the pixel changes: the
/// partial derivatives of origin + distance*direction with respect to picture x and y, without
/// their components along the ray. Without a distance, those of the direction alone.
struct Jacobian {
    V3d by_x, by_y;
    double maximum = 0.0;  ///< Singular values: the largest and the smallest stretch.
    double minimum = 0.0;  ///< Negative where the picture is mirrored.

    /// Whether it is finite and far from singular, so that the sign of `minimum` is reliable.
    [[nodiscard]] bool regular() const;
};

[[nodiscard]] Jacobian jacobian(const Ray& ray, const std::optional<double>& distance);

}  // namespace balcony::analyse
