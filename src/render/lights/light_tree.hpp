// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Imath/ImathBox.h>
#include <Imath/ImathVec.h>

namespace balcony::render {

/// Bounds of the position, direction and strength of a light's emission.
struct LightBounds {
    Imath::Box3f box;
    float power = 0.0F;
};

/// Chooses one of many lights at finite distances.
class LightTree {
public:
    struct Chosen {
        std::size_t light = 0;
        float probability = 0.0F;
    };

    explicit LightTree(const std::vector<LightBounds>& lights) : count_(lights.size()) {}

    /// Chooses by a number in [0, 1). Nothing if no light reaches the point. A normal of 0 stands
    /// for light from all sides.
    [[nodiscard]] std::optional<Chosen> choose(const Imath::V3f& position, const Imath::V3f& normal,
                                               float random) const;

    /// The probability that choose() gives this light.
    [[nodiscard]] float probability(const Imath::V3f& position, const Imath::V3f& normal,
                                    std::size_t light) const;

    [[nodiscard]] bool empty() const { return count_ == 0; }

private:
    std::size_t count_;
};

}  // namespace balcony::render
