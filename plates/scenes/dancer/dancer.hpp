// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A porcelain dancer on a turntable, in a photographer's studio (plate 17).

#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

[[nodiscard]] Result<scene::Scene> make_dancer(const SceneOptions& options);

}  // namespace balcony::plates
