// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Seams: lines of the picture across which rays jump.

#include <vector>

#include "analyse/measure/ray_field.hpp"

namespace balcony::analyse {

/// A place between two neighbouring samples where the ray jumps.
struct Crossing {
    std::size_t sample = 0;  ///< The left or upper one of the two.
    bool along_x = true;     ///< Its right neighbour is the other; else the lower one.
    V2d point;               ///< Known to far less than a pixel.
    double angle = 0.0;      ///< Between the directions on both sides, in radians.
    double distance = 0.0;   ///< Between the origins.
};

/// A connected line of crossings.
struct Seam {
    std::vector<Crossing> crossings;
    double length = 0.0;  ///< In pixels.
};

/// All jumps between neighbouring samples that halving the way between them does not remove.
/// `program` may be without derivatives; `unit` is the length that counts as much as a radian.
[[nodiscard]] std::vector<Crossing> find_crossings(const SampleGrid& grid,
                                                   const std::vector<Ray>& rays, RayField& program,
                                                   double unit);

/// Crossings joined to lines, the longest first.
[[nodiscard]] std::vector<Seam> join_seams(const SampleGrid& grid,
                                           const std::vector<Crossing>& crossings);

}  // namespace balcony::analyse
