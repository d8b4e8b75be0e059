// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/picture.hpp"
#include "balcony/scene.hpp"

namespace balcony::cli {

/// The default camera: the first of the scene, or else render::default_camera().
[[nodiscard]] Result<camera::Picture> default_picture(const scene::Scene& scene);

}  // namespace balcony::cli
