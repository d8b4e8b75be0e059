// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "film/denoise/noisy_image.hpp"

#include <algorithm>

namespace balcony::render {

NoisyImage::NoisyImage(std::size_t width, std::size_t height, std::size_t channels)
    : width_(width),
      height_(height),
      values_(channels, std::vector<float>((width + 2 * margin) * (height + 2 * margin), 0.0F)),
      variances_(values_) {}

void NoisyImage::continue_beyond_border() {
    const auto fill = [this](std::vector<float>& plane) {
        for (std::size_t y = 0; y < height_; ++y) {
            const auto row = plane.begin() + static_cast<std::ptrdiff_t>(index(0, y));
            const auto end = row + static_cast<std::ptrdiff_t>(width_);
            std::fill(row - margin, row, *row);
            std::fill(end, end + margin, *(end - 1));
        }
        const auto row = [&](std::size_t y) {
            return plane.begin() + static_cast<std::ptrdiff_t>(y * stride());
        };
        for (std::size_t y = 0; y < margin; ++y) {
            std::copy(row(margin), row(margin + 1), row(y));
            std::copy(row(margin + height_ - 1), row(margin + height_), row(margin + height_ + y));
        }
    };
    for (std::size_t channel = 0; channel < channels(); ++channel) {
        fill(values_[channel]);
        fill(variances_[channel]);
    }
}

}  // namespace balcony::render
