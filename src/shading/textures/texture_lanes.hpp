// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Look-ups in a texture for the rays of a packet together, in the widest registers of the machine.
// The results are those of single look-ups on all machines, bit for bit.

#include <array>
#include <cstddef>
#include <cstdint>

#include "balcony/scene.hpp"
#include "shading/textures/byte_scale.hpp"
#include "shading/textures/spill_file.hpp"

namespace balcony::render::texture_lanes {

inline constexpr std::size_t lane_count = 16;
using Floats = std::array<float, lane_count>;

constexpr Floats filled(float value) {
    Floats made{};
    made.fill(value);
    return made;
}

inline constexpr float middle = 0.5F;

/// As TextureFootprint, by lane. What no ray needs must be a point in the middle of the image,
/// which costs least.
struct alignas(64) Footprints {
    Floats at_u = filled(middle), at_v = filled(middle);
    Floats along_x_u{}, along_x_v{};
    Floats along_y_u{}, along_y_v{};
};

struct alignas(64) Colors {
    Floats red, green, blue;
};

/// The texels of a pyramid of 8 bits.
struct ByteLevels {
    /// A side of 2^n texels has n + 1 levels.
    static constexpr std::size_t max_count = 32;

    std::int32_t width = 0;  ///< Of the image. A level has halves of it, rounded down, but at least
    std::int32_t height = 0;  ///< one texel.
    std::int32_t last = 0;    ///< The number of the last level.
    /// The index of the first texel of each level.
    alignas(64) std::array<std::int32_t, max_count> first{};
    scene::Wrap wrap_u = scene::Wrap::repeat;
    scene::Wrap wrap_v = scene::Wrap::repeat;
    bool interpolated = true;
};

/// The means over the footprints, as MipPyramid::mean() for one. White where the point is
/// MipPyramid::max_coordinate or farther from 0; without a filter where the footprint is.
void set_means(const ByteLevels& levels, const TexelBlock& texels, const ByteScale& scale,
               const Footprints& footprints, Colors& colors);

}  // namespace balcony::render::texture_lanes
