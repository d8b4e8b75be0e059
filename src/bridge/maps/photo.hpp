// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "balcony/st_maps.hpp"

namespace balcony::bridge {

/// Linear light, premultiplied by alpha, row by row from the top left: red, green, blue, alpha.
struct Photo::Pixels {
    std::size_t width = 0;
    std::size_t height = 0;
    bool deep = false;    ///< Whole numbers of more than 8 bits.
    bool linear = false;  ///< Floats.
    std::vector<float> values{};
};

/// The curve of sRGB (IEC 61966-2-1).
inline float linear_from_display(float v) {
    return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
}
inline float display_from_linear(float v) {
    return v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1.0F / 2.4F) - 0.055F;
}

/// Pixels of linear light, premultiplied, as sRGB with straight alpha, or over black without alpha.
template <class Sample>
std::vector<Sample> display_samples(const std::vector<float>& values, bool alpha) {
    constexpr auto most = static_cast<float>(std::numeric_limits<Sample>::max());
    const auto sample = [](float value) {
        return static_cast<Sample>(std::lround(std::clamp(value, 0.0F, 1.0F) * most));
    };
    std::vector<Sample> samples;
    samples.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); i += 4) {
        const float opacity = values[i + 3];
        for (std::size_t k = 0; k < 3; ++k) {
            const float straight =
                alpha && opacity > 0.0F ? values[i + k] / opacity : values[i + k];
            samples.push_back(sample(display_from_linear(straight)));
        }
        if (alpha) {
            samples.push_back(sample(opacity));
        }
    }
    return samples;
}

}  // namespace balcony::bridge
