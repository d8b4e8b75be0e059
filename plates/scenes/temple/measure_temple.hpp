// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What plates 12, 13 and 16 measure of the temple.

#include <string>
#include <vector>

#include "balcony/render.hpp"
#include "balcony/scene.hpp"

namespace balcony::plates {

/// Between which distances from the z axis and which heights an object lies.
struct Extent {
    double min_r = 0.0, max_r = 0.0;
    double min_z = 0.0, max_z = 0.0;

    [[nodiscard]] bool about(const scene::V3d& point) const;  ///< Is its distance one of those?
};

/// Throws std::runtime_error if no object of the scene has that name.
[[nodiscard]] Extent extent_of(const scene::Scene& scene, const std::string& object);

/// The least distance of ray origins below the arches from the axis of a column.
[[nodiscard]] double clearance(const render::Film& film);

/// The share of a picture's pixels that show objects whose names begin so.
[[nodiscard]] double share_of(const render::Film& film, const std::string& begin);

/// Of the pixels that show columns, the share whose rays meet the side that is turned away from the
/// temple's axis, on their way towards it.
[[nodiscard]] double share_from_outside(const render::Film& film);

}  // namespace balcony::plates
