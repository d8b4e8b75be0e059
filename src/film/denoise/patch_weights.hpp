// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "balcony/film.hpp"
#include "film/denoise/noisy_image.hpp"

namespace balcony::render {

/// The weights of non-local means with known variance: how similar the patches around two pixels
/// are, beyond the difference that noise explains (Rousselle, Knaus and Zwicker, "Adaptive
/// Rendering with Non-Local Means Filtering", 2012, equations 4 to 6). Belongs to one thread.
class PatchWeights {
public:
    static constexpr std::size_t patch_radius = 3;

    /// A larger tolerance takes more differences for noise.
    PatchWeights(const NoisyImage& image, float tolerance);

    /// The weights, from 0 to 1, of the pixels at an offset from those of a tile, row by row. The
    /// offset is at most NoisyImage::margin - patch_radius.
    void find(const Region& tile, std::ptrdiff_t right, std::ptrdiff_t down,
              std::vector<float>& weights);

private:
    const NoisyImage& image_;
    float tolerance_;
    std::vector<float> distances_;  // Of pixels; kept for its memory.
    std::vector<float> sums_;       // Over the rows of patches.
};

}  // namespace balcony::render
