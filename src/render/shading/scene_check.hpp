// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/scene.hpp"

namespace balcony::render {

/// Whether a scene holds together: indices that lead somewhere, normals and texture coordinates
/// empty or one a vertex. Errors name what does not.
[[nodiscard]] Diagnostics check(const scene::Scene& scene);

}  // namespace balcony::render
