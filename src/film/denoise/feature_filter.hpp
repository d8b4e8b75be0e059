// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "film/denoise/noisy_image.hpp"

namespace balcony::render {

/// Replaces the values of an image by means over similar patches nearby.
void smooth(NoisyImage& image, float tolerance, std::size_t threads);

/// The image without noise, by local regression: around each pixel, the colour is fitted by a
/// linear function of the features, with the weights of similar patches, and the fit stands for the
/// colour (Bitterli et al., "Nonlinearly Weighted First-order Regression for Denoising Monte Carlo
/// Renderings", 2016). Variances become 0. Features have the size of the image and no noise.
[[nodiscard]] NoisyImage regressed(const NoisyImage& color, const NoisyImage& features,
                                   std::size_t threads);

}  // namespace balcony::render
