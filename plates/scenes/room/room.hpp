// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A furnished living room: closed, lit by two windows and lamps, and free to stand in its middle.
//
// z is up, units are metres. The floor is at z = 0 and its middle at the origin; x runs along the
// longer side, towards the fireplace.

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

[[nodiscard]] Result<scene::Scene> make_room(const SceneOptions& options);

}  // namespace balcony::plates
