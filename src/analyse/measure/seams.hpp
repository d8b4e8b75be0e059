// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Seams: lines of the picture across which rays jump.

#include <vector>

#include "analyse/measure/ray_field.hpp"

namespace balcony::analyse {

/// A position between two neighbouring samples where the ray jumps.
struct Crossing {
    std::size_t sample = 0;  ///< The left or upper one of the two.
    bool along_x = true;     ///< The other sample is its right neighbour; otherwise its lower one.
    V2d point;               ///< Accurate to far less than a pixel.
    double angle = 0.0;      ///< Between the directions on both sides, in radians.
    double distance = 0.0;   ///< Between the origins.
};

/// A connected line of crossings.
struct Seam {
    std::vector<Crossing> crossings;
    double length = 0.0;  ///< In pixels.
};

/// All jumps between neighbouring samples that remain when the interval is subdivided.
/// `program` needs no derivatives; `unit` is the length that is weighted like one radian.
[[nodiscard]] std::vector<Crossing> find_crossings(const SampleGrid& grid,
                                                   const std::vector<Ray>& rays, RayField& program,
                                                   double unit);

/// Crossings joined to lines, the longest first.
[[nodiscard]] std::vector<Seam> join_seams(const SampleGrid& grid,
                                           const std::vector<Crossing>& crossings);

}  // namespace balcony::analyse
