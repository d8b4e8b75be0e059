// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "balcony/rays.hpp"
#include "balcony/scene.hpp"

namespace balcony::bench {

/// Embree by itself: the speed that a renderer would have if all else cost nothing.
class BareEmbree {
public:
    explicit BareEmbree(const scene::Scene& scene);
    ~BareEmbree();
    BareEmbree(BareEmbree&&) noexcept;
    BareEmbree& operator=(BareEmbree&&) = delete;

    /// The seconds that Embree takes to trace all valid rays of the tiles once, tile by tile, in
    /// coherent packets of 4 x 4 neighbours. Computing the rays does not count.
    [[nodiscard]] double seconds(const rays::RayProgram& rays,
                                 const std::vector<rays::Tile>& tiles) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace balcony::bench
