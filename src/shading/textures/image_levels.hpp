// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "balcony/scene.hpp"

namespace balcony::render {

/// An image and its mip levels, as look-ups see them.
struct ImageLevels {
    /// A side of 2^n texels has n + 1 levels.
    static constexpr std::size_t max_count = 32;
    /// An elongated footprint is the mean of at most so many places.
    static constexpr int max_probes = 16;
    /// Beyond this, a float cannot distinguish the texels of an image.
    static constexpr float max_coordinate = 1e6F;

    std::int32_t width = 0;  ///< Of the image. A level has halves of it, rounded down, but at least
    std::int32_t height = 0;  ///< one texel.
    std::int32_t last = 0;    ///< The number of the last level.
    /// The index of the first texel of each level, for look-ups in lanes.
    alignas(64) std::array<std::int32_t, max_count> first{};
    scene::Wrap wrap_u = scene::Wrap::repeat;
    scene::Wrap wrap_v = scene::Wrap::repeat;
    bool interpolated = true;
};

}  // namespace balcony::render
