// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The straight parts of a bent ray: how many there are, and what families of bends say of them.

#include <cstddef>
#include <functional>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/catalogue.hpp"

namespace balcony::camera {

/// The most straight parts that a bend divides a path into.
inline constexpr std::size_t max_straight_parts = 256;

/// The knots of a ray's path in so many parts: one more than there are parts.
using KnotsOfParts = std::function<std::vector<ObjectPoint>(const CentralRay& ray,
                                                            std::size_t parts, Emitter& emit)>;

/// How finely a path is divided.
struct Division {
    double tolerance = 0.001;
    std::size_t parts = 0;  ///< 0: as many as the tolerance needs.
};

/// The parameters of a bend with a division, and their values.
[[nodiscard]] std::vector<StageParameter> division_parameters();
[[nodiscard]] Division division_of(const Arguments& a);

/// The number of parts of all rays. That which a tolerance needs is the least one for which no
/// point of the path is farther from the straight parts than the tolerance, on the rays of a grid
/// over the picture at time 0, where the path of at least twice as many parts stands for the exact
/// one. If that takes more than max_straight_parts, an error is reported, and a warning if the
/// exact one of some ray is not finite.
[[nodiscard]] std::size_t straight_parts(const Division& division, const CentralRay& ray,
                                         const KnotsOfParts& knots, Emitter& emit);

/// Reports how many of these rays have knots that are elsewhere with twice as many parts, as those
/// of an integration have whose steps are too long.
void report_unsteady_paths(std::size_t parts, const CentralRay& ray, const KnotsOfParts& knots,
                           Emitter& emit);

/// The points of a grid over the picture that almost reaches its borders.
[[nodiscard]] std::vector<Imath::V2d> trial_points(const CentralRay& ray, const Emitter& emit);

}  // namespace balcony::camera
