// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "balcony/camera.hpp"

namespace balcony::bridge {

// What Cycles tells a camera shader about its lens: a point of the aperture and the distance that
// is sharp, both in scene units; and whether the camera's own focus is wanted instead.
inline constexpr std::string_view aperture_x_input = "aperture_x";
inline constexpr std::string_view aperture_y_input = "aperture_y";
inline constexpr std::string_view focal_distance_input = "focal_distance";
inline constexpr std::string_view own_focus_input = "own_focus";

/// The camera with the aperture and the focus of Blender's camera in the place of its own, or with
/// the middle of a lens that has no aperture across its rays; itself if it has no lens.
[[nodiscard]] Result<camera::Camera> with_blender_lens(const camera::Camera& camera);

}  // namespace balcony::bridge
