// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A gallery above a harbour, after Escher's lithograph "Print Gallery". One print on its end wall
// hangs where it can show the gallery itself, as it is seen from the place of its eye.
//
// z is up, units are metres. The end wall is x = 7, the arcade is at y = 2.6.

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

/// The straight picture: what the eye (0, 0, eye_height) sees on a plane at the distance 1, to the
/// left and upwards. The print is a copy of it on the end wall, picture_scale times smaller as seen
/// from the eye; (common_y, common_z) is the place that both have in common.
namespace print_gallery {
inline constexpr double eye_height = 1.7;
inline constexpr double wall_distance = 7.0;
inline constexpr double half_width = 1.1;
inline constexpr double half_height = 0.9;
inline constexpr double picture_scale = 17.0;
inline constexpr double common_y = 0.03;
inline constexpr double common_z = 0.01;
}  // namespace print_gallery

[[nodiscard]] Result<scene::Scene> make_print_gallery(const SceneOptions& options);

}  // namespace balcony::plates
