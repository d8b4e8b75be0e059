// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The wall of plates 4 to 8: seven by seven units about the origin in the plane x = 0, which are
// seen from the side of +x, with z up and y to the right. Boxes stand at the corners of the units,
// cylinders join neighbouring boxes, a thin piece of wall fills each unit, and a picture hangs
// before it.

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

inline constexpr int wall_units = 7;       ///< Along each side.
inline constexpr double wall_unit = 20.0;  ///< Width and height of a unit.

/// The scene, z up. The objects of a unit are "unit R C picture", "unit R C frame" and "unit R C
/// wall" with the row R and the column C from 1 to 7, counted from the upper left.
[[nodiscard]] Result<scene::Scene> make_wall(const SceneOptions& options);

}  // namespace balcony::plates
