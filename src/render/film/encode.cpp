// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "balcony/display_file.hpp"
#include "balcony/film.hpp"
#include "render/film/displayed_pixel.hpp"

namespace balcony::render {

namespace {

// IEC 61966-2-1; NaN becomes black.
float srgb_from_linear(float value) {
    if (!(value > 0.0F)) {
        return 0.0F;
    }
    const float c = std::min(value, 1.0F);
    return c <= 0.0031308F ? 12.92F * c : 1.055F * std::pow(c, 1.0F / 2.4F) - 0.055F;
}

template <class Sample>
Sample quantised(float value) {
    constexpr auto maximum = static_cast<float>(std::numeric_limits<Sample>::max());
    return static_cast<Sample>(std::clamp(value, 0.0F, 1.0F) * maximum + 0.5F);
}

template <class Sample>
std::vector<Sample> to_samples(const Film& film, const DisplayOptions& options, bool with_alpha) {
    const auto gain = static_cast<float>(std::exp2(options.exposure));
    std::vector<Sample> samples;
    samples.reserve(film.window.size() * (with_alpha ? 4 : 3));
    for (std::size_t y = 0; y < film.window.height; ++y) {
        for (std::size_t x = 0; x < film.window.width; ++x) {
            const Color4f shown =
                displayed_pixel(film, film.window.x + x, film.window.y + y, gain, options.view);
            const bool visible = shown.a > 0.0F;
            // Without alpha, the picture is in front of black.
            const float scale = !visible ? 0.0F : with_alpha ? 1.0F / shown.a : 1.0F;
            for (const float c : {shown.r, shown.g, shown.b}) {
                samples.push_back(quantised<Sample>(srgb_from_linear(c * scale)));
            }
            if (with_alpha) {
                samples.push_back(quantised<Sample>(visible ? shown.a : 0.0F));
            }
        }
    }
    return samples;
}

}  // namespace

Result<std::vector<std::uint8_t>> encode(const Film& film, const DisplayFormat& format,
                                         const DisplayOptions& options) {
    const int bits = options.bits.value_or(format.bits);
    if ((bits != 8 && bits != 16) || bits > format.max_bits || !std::isfinite(options.exposure)) {
        return error(fmt::format("a {} file cannot have {} bits per channel and an exposure of {}",
                                 format.extension, bits, options.exposure),
                     {},
                     fmt::format("use 8{} bits and a finite exposure",
                                 format.max_bits == 16 ? " or 16" : ""));
    }
    const DisplaySize size{film.window.width, film.window.height, format.has_alpha ? 4U : 3U};
    return bits == 8
               ? encode(to_samples<std::uint8_t>(film, options, format.has_alpha), size, format)
               : encode(to_samples<std::uint16_t>(film, options, format.has_alpha), size, format);
}

}  // namespace balcony::render
