// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The gallery of plates 1 to 3: a closed rectangular room about the origin, z up, x along its
// longer side. Its four walls are set with boxes on a grid, cylinders join neighbouring boxes, a
// thin wall fills the space between; seven pictures hang before them.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

using Imath::M44d;
using Imath::V3d;

/// Half the inner extents of the room, from wall to wall along x and y and floor to ceiling.
inline constexpr double room_half_x = 49.0;
inline constexpr double room_half_y = 29.0;
inline constexpr double room_half_z = 24.0;

enum class Wall : std::uint8_t { y_plus, x_plus, y_minus, x_minus };

/// Places things on a wall: (x, y, z) of the mesh go right along the wall as it is seen from
/// inside, up, and into the room, from the middle of the wall's surface.
[[nodiscard]] M44d room_from_wall(Wall wall);

/// Half the length of a wall.
[[nodiscard]] double half_length(Wall wall);

/// Where a picture hangs and what it shows. The names of its nodes are "picture N" and "frame N".
struct Hanging {
    std::string name;  ///< Of the picture in plates/pictures.
    Wall wall;
    double right;  ///< Of its middle, from the middle of the wall.
    double up;     ///< Of its middle.
    double width;  ///< Without the frame.
    double height;
};

/// Number 1 is the first. They go round the room from left to right.
[[nodiscard]] const std::array<Hanging, 7>& hangings();

inline constexpr double frame_width = 0.8;     ///< Around the picture.
inline constexpr double picture_offset = 1.5;  ///< Of the picture's plane from the wall.
inline constexpr double box_size = 2.4;        ///< Half of it stands out of the wall.

/// The scene, axes z_up.
[[nodiscard]] Result<scene::Scene> make_gallery(const SceneOptions& options);

}  // namespace balcony::plates
