// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What of the light from infinitely far away reaches the places of a scene: in a room, what its
// windows let in.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Imath/ImathVec.h>

#include "shading/geometry/place_tree.hpp"
#include "shading/lights/environment_map.hpp"

namespace balcony::render {

/// What some directions to the environment, chosen by EnvironmentMap::sample(), and those to the
/// suns let through to a point.
struct DistantProbe {
    Imath::V3f position;
    std::uint32_t directions = 0;
    std::vector<std::uint16_t> open;  ///< The sectors of directions that arrive; some repeatedly.
    std::vector<float> suns;          ///< From 0 to 1, of each.
};

/// An estimate for each part of space, to sample lights by. Immutable.
class DistantVisibility {
public:
    /// What reaches a place.
    struct Place {
        float environment = 1.0F;  ///< The part of its light.
        std::vector<float> suns;   ///< The parts of theirs.
        float known = 0.0F;        ///< How far `sectors` can be trusted, below 1.
        /// Cumulative, from 0 to 1: where the light of the environment arrives from.
        std::array<float, EnvironmentMap::sector_count + 1> sectors{};

        [[nodiscard]] float probability(std::size_t sector) const {
            return sectors[sector + 1] - sectors[sector];
        }
    };

    /// At least one probe. The result does not depend on their order as PlaceTree says.
    explicit DistantVisibility(std::vector<DistantProbe> probes);

    [[nodiscard]] const Place& at(const Imath::V3f& position) const { return places_.at(position); }

private:
    PlaceTree<Place> places_;
};

/// A surface with this normal, which is 0 for all sides, at a place; null if it is not known what
/// reaches it.
struct DistantReceiver {
    Imath::V3f normal;
    const DistantVisibility::Place* place = nullptr;
};

}  // namespace balcony::render
