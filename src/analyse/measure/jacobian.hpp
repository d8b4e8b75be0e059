// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The map from the picture to what it shows, to first order.

#include <optional>

#include "analyse/measure/ray_field.hpp"

namespace balcony::analyse {

/// How the point that a ray reaches at a distance moves with the pixel, seen along the ray: the
/// partial derivatives of origin + distance*direction by picture x and y, without their parts along
/// the ray. Without a distance, those of the direction alone.
struct Jacobian {
    V3d by_x, by_y;
    double maximum = 0.0;  ///< Singular values: the largest and the least stretch.
    double minimum = 0.0;  ///< Negative where the picture is mirrored.

    /// Finite, and far from losing a dimension, so that the sign of `least` means something.
    [[nodiscard]] bool regular() const;
};

[[nodiscard]] Jacobian jacobian(const Ray& ray, const std::optional<double>& distance);

}  // namespace balcony::analyse
