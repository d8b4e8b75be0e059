// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A round temple in the desert at evening (plates 12, 13 and 16).

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

[[nodiscard]] Result<scene::Scene> make_temple(const SceneOptions& options);

}  // namespace balcony::plates
