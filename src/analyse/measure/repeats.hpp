// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Repeated views: points of the picture that have the same ray.

#include <optional>
#include <vector>

#include "analyse/measure/ray_field.hpp"

namespace balcony::analyse {

struct Repeats {
    /// For each sample how many points of the picture have its ray, itself among them; 0 where
    /// there is no ray or none that can be told apart from its neighbours'.
    std::vector<std::uint8_t> views;
    /// For each sample one other such point; not a number where there is none.
    std::vector<V2d> other;
};

/// Rays are the same if their lines and directions are, to a tenth of a pixel; where on the line
/// they begin does not count. `distance` and `unit` as for jacobian() and find_crossings().
[[nodiscard]] Repeats find_repeats(const SampleGrid& grid, const std::vector<Ray>& rays,
                                   RayField& program, const std::optional<double>& distance,
                                   double unit);

}  // namespace balcony::analyse
