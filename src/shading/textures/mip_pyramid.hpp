// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A texture in memory: an image and its mip levels down to one texel, after Williams, "Pyramidal
// Parametrics" (1983).

#include <cstddef>
#include <vector>

#include <Imath/ImathColor.h>

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "shading/textures/byte_scale.hpp"
#include "shading/textures/spill_file.hpp"
#include "shading/textures/texture_footprint.hpp"
#include "shading/textures/texture_lanes.hpp"
#include "shading/textures/texture_reader.hpp"

namespace balcony::render {

/// Immutable; look-ups may come from any number of threads.
class MipPyramid {
public:
    /// Reads the image and computes its mip levels, each from the one before by the mean over the
    /// area of each texel, in linear colours. An image of 8 bits stays one of 8 bits, with each
    /// texel rounded once; other images have half floats. They are in memory, or in a file if one
    /// is given: the image itself is read for it once more, when a look-up needs it first. An error
    /// is that of the reader, whose stop it obeys. The texture says how the image is continued and
    /// magnified.
    [[nodiscard]] static Result<MipPyramid> read(TextureReader& image,
                                                 const scene::Texture& texture,
                                                 SpillFile* file = nullptr);
    /// The memory that the pyramid of an image takes, in bytes.
    [[nodiscard]] static std::size_t bytes(const TextureReader& image);

    /// The mean over a footprint: red, green, blue, alpha. Texels are interpolated linearly, and
    /// so are neighbouring levels; those of the image itself are not if the texture says so. An
    /// elongated footprint is the mean of up to ImageLevels::max_probes places along its longer
    /// axis; one that is longer still is widened. White where the point is
    /// ImageLevels::max_coordinate or farther from 0; without a filter where the footprint is.
    [[nodiscard]] Imath::Color4f mean(const TextureFootprint& footprint) const;
    /// Red, green and blue of the same for the rays of a packet, bit for bit.
    void set_means(const texture_lanes::Footprints& footprints, LaneVectors& colors) const;

private:
    MipPyramid(const TextureReader& image, const scene::Texture& texture,
               std::vector<std::size_t> first, TexelBlock texels);

    template <class Codec>
    [[nodiscard]] static Result<MipPyramid> read_to_memory(TextureReader& image,
                                                           const scene::Texture& texture,
                                                           const Codec& codec);
    template <class Codec>
    [[nodiscard]] static Result<MipPyramid> read_to_file(TextureReader& image,
                                                         const scene::Texture& texture,
                                                         const Codec& codec, SpillFile& file);

    ImageLevels image_;
    std::vector<std::size_t> first_;  // The index of the first texel of each level.
    const ByteScale* color_;
    const ByteScale* alpha_;
    bool has_bytes_;           // ByteTexel rather than HalfTexel.
    bool fits_lanes_ = false;  // It has bytes, and the indices of texels fit.
    TexelBlock texels_;        // Of all levels.
};

}  // namespace balcony::render
