// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Look-ups in a texture for the rays of a packet together, in the widest registers of the machine.
// The results are those of single look-ups on all machines, bit for bit.

#include "shading/lanes/lane_arrays.hpp"
#include "shading/textures/byte_scale.hpp"
#include "shading/textures/image_levels.hpp"
#include "shading/textures/spill_file.hpp"

namespace balcony::render::texture_lanes {

/// As TextureFootprint, by lane. What no ray needs must be what another needs, which costs least.
struct Footprints {
    LanePairs at, along_x, along_y;
};

/// The means over the footprints, as MipPyramid::mean() for one, in red, green and blue. The texels
/// have 8 bits.
void set_means(const ImageLevels& image, const TexelBlock& texels, const ByteScale& scale,
               const Footprints& footprints, LaneVectors& colors);

}  // namespace balcony::render::texture_lanes
