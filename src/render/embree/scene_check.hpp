// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/scene.hpp"

namespace balcony::render {

/// Whether a scene is consistent: valid indices, and normals and texture coordinates
/// empty or one per vertex. Errors name the inconsistent part.
[[nodiscard]] Diagnostics check(const scene::Scene& scene);

}  // namespace balcony::render
