// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Repeated views: points of the picture that have the same ray.

#include <optional>
#include <vector>

#include "analyse/measure/ray_field.hpp"

namespace balcony::analyse {

struct Repeats {
    /// For each sample, the number of points of the picture with its ray, including itself; 0 where
    /// there is no ray, or none that is distinguishable from those of its neighbours.
    std::vector<std::uint8_t> views;
    /// For each sample one other such point; NaN where there is none.
    std::vector<V2d> other;
    /// No view was compared with as many others as may be, so that some were left out.
    bool complete = true;
};

/// Rays are the same if their lines and directions agree to a tenth of a pixel; the start on the
/// line is ignored. `distance` and `unit` as for jacobian() and find_crossings().
[[nodiscard]] Repeats find_repeats(const SampleGrid& grid, const std::vector<Ray>& rays,
                                   RayField& program, const std::optional<double>& distance,
                                   double unit, const Work& work);

}  // namespace balcony::analyse
