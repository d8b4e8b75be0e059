// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "shading/textures/texture_reader.hpp"

namespace balcony::render {

/// The linear values of the 256 codes of a channel.
class ByteScale {
public:
    /// Of a colour channel with this encoding. There is one object for each.
    [[nodiscard]] static const ByteScale& of(TextureEncoding encoding);

    [[nodiscard]] float decode(std::uint8_t code) const { return values_[code]; }
    /// By code.
    [[nodiscard]] const float* values() const { return values_.data(); }

    /// The nearest code, as seen in the encoding, of a value from 0 to 1.
    [[nodiscard]] std::uint8_t encode(float value) const {
        const std::uint8_t code = starts_[static_cast<std::size_t>(value * steps)];
        // A step is shorter than any code, of which those of dark sRGB colours are 1 / 3295.
        return static_cast<std::uint8_t>(code + (value > upper_limits_[code] ? 1 : 0));
    }

private:
    static constexpr float steps = 4096.0F;

    explicit ByteScale(TextureEncoding encoding);

    std::array<float, 256> values_{};
    std::array<float, 256> upper_limits_{};    // Above them, the next code is nearer.
    std::array<std::uint8_t, 4097> starts_{};  // The codes of the multiples of 1 / steps.
};

}  // namespace balcony::render
