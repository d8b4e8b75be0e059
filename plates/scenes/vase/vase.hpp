// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// An amphora in the black-figure manner, painted all round, on a plinth (plate 18).

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

[[nodiscard]] Result<scene::Scene> make_vase(const SceneOptions& options);

}  // namespace balcony::plates
