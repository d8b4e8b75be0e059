// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A texture in memory: an image and its mip levels down to one texel, after Williams, "Pyramidal
// Parametrics" (1983).

#include <cstddef>
#include <optional>
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
    /// Reads the image into memory, or into a file if one is given, and computes its mip levels,
    /// each from the one before by the mean over the area of each texel, in linear colours. An
    /// image of 8 bits stays one of 8 bits, with each texel rounded once; other images have half
    /// floats. An error is that of the reader. The texture says how the image is continued and
    /// magnified.
    [[nodiscard]] static Result<MipPyramid> read(TextureReader& image,
                                                 const scene::Texture& texture,
                                                 SpillFile* file = nullptr);
    /// The memory that the pyramid of an image takes, in bytes.
    [[nodiscard]] static std::size_t bytes(const TextureReader& image);

    /// The mean over a footprint: red, green, blue, alpha. Texels are interpolated linearly, and
    /// so are neighbouring levels; those of the image itself are not if the texture says so. An
    /// elongated footprint is the mean of up to max_probes places along its longer axis; one that
    /// is longer still is widened. White where the point is max_coordinate or farther from 0;
    /// without a filter where the footprint is.
    [[nodiscard]] Imath::Color4f mean(const TextureFootprint& footprint) const;
    /// The same for the rays of a packet, bit for bit.
    void set_means(const texture_lanes::Footprints& footprints,
                   texture_lanes::Colors& colors) const;

    static constexpr int max_probes = 16;
    static constexpr float max_coordinate = 1e6F;

private:
    struct Level {
        int width = 0;
        int height = 0;
        std::size_t first = 0;  // The index of its first texel.
    };

    MipPyramid(const TextureReader& image, const scene::Texture& texture, TexelBlock texels);

    [[nodiscard]] static std::vector<Level> levels_of(const TextureReader& image);
    void set_byte_levels();
    [[nodiscard]] Imath::Color4f mean_within(const TextureFootprint& footprint) const;
    template <class Codec>
    [[nodiscard]] std::optional<Diagnostic> fill(TextureReader& image, const Codec& codec);
    template <class Codec>
    [[nodiscard]] Imath::Color4f mean(const TextureFootprint& footprint, const Codec& codec) const;

    std::vector<Level> levels_;
    scene::Wrap wrap_u_;
    scene::Wrap wrap_v_;
    bool interpolated_;
    const ByteScale* color_;
    const ByteScale* alpha_;
    bool has_bytes_;     // ByteTexel rather than HalfTexel.
    TexelBlock texels_;  // Of all levels.
    // Nothing if texels have halves, or their indices do not fit.
    std::optional<texture_lanes::ByteLevels> byte_levels_;
};

}  // namespace balcony::render
