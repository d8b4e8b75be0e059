// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scene cameras: a camera of a scene file as a camera of the abstract camera machine.

#include "balcony/base.hpp"
#include "balcony/camera.hpp"
#include "balcony/scene.hpp"

namespace balcony::data {

/// The camera in a scene's axes, made of the built-in stages. Its rays start on the near plane. In
/// a picture of another aspect the height stays the same and more or less is seen to the sides.
[[nodiscard]] Result<camera::Camera> make_camera(const scene::Camera& camera, Axes axes);

}  // namespace balcony::data
