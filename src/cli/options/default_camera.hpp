// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/picture.hpp"
#include "balcony/render.hpp"
#include "balcony/scene.hpp"

namespace balcony::cli {

/// The picture of a camera of a scene with these axes.
[[nodiscard]] Result<camera::Picture> picture_of(const scene::Camera& camera, Axes axes);

/// That of the default camera: the first of the scene, or else that of its renderer.
[[nodiscard]] Result<camera::Picture> default_picture(const scene::Scene& scene,
                                                      const render::Renderer& renderer);

}  // namespace balcony::cli
