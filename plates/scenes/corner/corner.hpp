// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The gallery of plates 9 to 11: two walls at a right angle with two pictures each.

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

[[nodiscard]] Result<scene::Scene> make_corner(const SceneOptions& options);

}  // namespace balcony::plates
