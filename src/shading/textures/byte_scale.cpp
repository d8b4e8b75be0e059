// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/textures/byte_scale.hpp"

#include <limits>

namespace balcony::render {

ByteScale::ByteScale(TextureEncoding encoding) {
    const auto linear = [encoding](float code) {
        const float value = code / 255.0F;
        return encoding == TextureEncoding::srgb ? linear_from_srgb(value) : value;
    };
    for (std::size_t code = 0; code < values_.size(); ++code) {
        values_[code] = linear(static_cast<float>(code));
        upper_limits_[code] = linear(static_cast<float>(code) + 0.5F);
    }
    upper_limits_.back() = std::numeric_limits<float>::infinity();
    std::uint8_t code = 0;
    for (std::size_t step = 0; step < starts_.size(); ++step) {
        while (static_cast<float>(step) / steps > upper_limits_[code]) {
            ++code;
        }
        starts_[step] = code;
    }
}

const ByteScale& ByteScale::of(TextureEncoding encoding) {
    static const std::array<ByteScale, 2> scales{ByteScale(TextureEncoding::linear),
                                                 ByteScale(TextureEncoding::srgb)};
    return scales[static_cast<std::size_t>(encoding)];
}

}  // namespace balcony::render
