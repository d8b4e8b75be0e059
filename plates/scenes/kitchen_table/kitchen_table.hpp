// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A kitchen table with fruit, a basket, a jar and a jug, after Paul Cézanne (plate 23).

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

/// The scene, z up, in metres: the top of the table is z = 0, the viewer looks along y.
[[nodiscard]] Result<scene::Scene> make_kitchen_table(const SceneOptions& options);

}  // namespace balcony::plates
