// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The meshes of a house, one for each of its materials.

#include "scenes/street/house.hpp"

namespace balcony::plates::street {

inline constexpr double house_depth = 9.0;

struct HouseParts {
    MeshBuilder front, trim, frames, glass, curtain, lamplight, roof, slate, sides, accent, iron,
        leaves, flowers;
};

/// Adds what is above the eaves: a gable or a cornice, the roof, dormers, a chimney. The seed
/// decides what differs from house to house.
void add_house_top(HouseParts& parts, const Plan& plan, double eaves, std::uint32_t seed);

}  // namespace balcony::plates::street
