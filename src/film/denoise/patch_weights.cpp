// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "film/denoise/patch_weights.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::render {

PatchWeights::PatchWeights(const NoisyImage& image, float tolerance)
    : image_(image), tolerance_(tolerance) {}

void PatchWeights::find(const Region& tile, std::ptrdiff_t right, std::ptrdiff_t down,
                        std::vector<float>& weights) {
    constexpr std::size_t side = 2 * patch_radius + 1;
    const std::size_t width = tile.width + 2 * patch_radius;
    const std::size_t height = tile.height + 2 * patch_radius;
    const auto stride = static_cast<std::ptrdiff_t>(image_.stride());
    const std::ptrdiff_t offset = down * stride + right;
    distances_.assign(width * height, 0.0F);
    const float spread = tolerance_ * tolerance_;
    for (std::size_t channel = 0; channel < image_.channels(); ++channel) {
        for (std::size_t y = 0; y < height; ++y) {
            const std::size_t first =
                image_.index(tile.x, tile.y + y) - patch_radius * image_.stride() - patch_radius;
            const float* value = image_.values(channel).data() + first;
            const float* variance = image_.variances(channel).data() + first;
            float* distance = distances_.data() + y * width;
            for (std::size_t x = 0; x < width; ++x) {
                const float here = variance[x];
                const float there = *(variance + x + offset);
                const float difference = value[x] - *(value + x + offset);
                distance[x] += (difference * difference - (here + std::min(here, there))) /
                               (1e-10F + spread * (here + there));
            }
        }
    }
    sums_.resize(tile.width * height);
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < tile.width; ++x) {
            float sum = 0.0F;
            for (std::size_t i = 0; i < side; ++i) {
                sum += distances_[y * width + x + i];
            }
            sums_[y * tile.width + x] = sum;
        }
    }
    const float mean = 1.0F / static_cast<float>(side * side * image_.channels());
    weights.resize(tile.size());
    for (std::size_t y = 0; y < tile.height; ++y) {
        for (std::size_t x = 0; x < tile.width; ++x) {
            float sum = 0.0F;
            for (std::size_t i = 0; i < side; ++i) {
                sum += sums_[(y + i) * tile.width + x];
            }
            weights[y * tile.width + x] = std::exp(-std::max(mean * sum, 0.0F));
        }
    }
}

}  // namespace balcony::render
