// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A plant in a terracotta pot on a table by a window: the picture that plate 11 enlarges.

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

[[nodiscard]] Result<scene::Scene> make_plant(const SceneOptions& options);

}  // namespace balcony::plates
