// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What stands in the street.

#include "common/mesh_builder.hpp"
#include "common/scene_builder.hpp"
#include "scenes/street/house.hpp"

namespace balcony::plates::street {

/// Trees, lamps, bicycles, a tram, people and café tables.
void add_furniture(SceneBuilder& builder, const Stock& stock);

}  // namespace balcony::plates::street
