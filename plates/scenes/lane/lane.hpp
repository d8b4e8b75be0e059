// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A lane of an old town that turns round three corners.
//
// z is up, units are metres. The middle of the lane goes from corner to corner; the fronts of the
// houses stand at half_width beside it.

#include <array>
#include <cstddef>

#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

namespace lane {

inline constexpr double half_width = 5.5;
/// Where the lane begins, its three corners, and its end before the church.
inline constexpr std::array<Imath::V2d, 5> corners{
    {{-16.0, 0.0}, {36.0, 0.0}, {36.0, 36.0}, {74.0, 36.0}, {74.0, 78.0}}};
inline constexpr std::size_t legs = corners.size() - 1;

}  // namespace lane

/// Fronts are the objects "left house 1.1 front" (the first of the first leg), "right house 1.1
/// front", ...
[[nodiscard]] Result<scene::Scene> make_lane(const SceneOptions& options);

}  // namespace balcony::plates
