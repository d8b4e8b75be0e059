// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/picture.hpp"
#include "balcony/scene.hpp"

namespace balcony::cli {

/// A pinhole camera before the scene and a little above it that sees the whole, for those who
/// name no camera.
[[nodiscard]] Result<camera::Picture> default_picture(const scene::Scene& scene);

}  // namespace balcony::cli
