// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace balcony::render {

/// Channels of an image with the variance of each value, continued beyond the border by its nearest
/// pixels.
class NoisyImage {
public:
    /// How far the image continues.
    static constexpr std::size_t margin = 12;

    NoisyImage(std::size_t width, std::size_t height, std::size_t channels);

    [[nodiscard]] std::size_t width() const { return width_; }
    [[nodiscard]] std::size_t height() const { return height_; }
    [[nodiscard]] std::size_t channels() const { return values_.size(); }
    [[nodiscard]] std::size_t stride() const { return width_ + 2 * margin; }
    /// The index of a pixel; that of a neighbour differs by 1 or stride().
    [[nodiscard]] std::size_t index(std::size_t x, std::size_t y) const {
        return (y + margin) * stride() + x + margin;
    }
    [[nodiscard]] std::vector<float>& values(std::size_t channel) { return values_[channel]; }
    [[nodiscard]] std::vector<float>& variances(std::size_t channel) { return variances_[channel]; }
    [[nodiscard]] const std::vector<float>& values(std::size_t channel) const {
        return values_[channel];
    }
    [[nodiscard]] const std::vector<float>& variances(std::size_t channel) const {
        return variances_[channel];
    }

    /// Fills what is beyond the border.
    void continue_beyond_border();

private:
    std::size_t width_;
    std::size_t height_;
    std::vector<std::vector<float>> values_;
    std::vector<std::vector<float>> variances_;
};

}  // namespace balcony::render
