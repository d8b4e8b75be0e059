// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "balcony/film.hpp"
#include "balcony/png_file.hpp"
#include "render/film/displayed_pixel.hpp"

namespace balcony::render {

namespace {

constexpr std::size_t channels = 4;

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
std::vector<Sample> to_samples(const Film& film, const PngOptions& options) {
    const auto gain = static_cast<float>(std::exp2(options.exposure));
    std::vector<Sample> samples;
    samples.reserve(film.window.size() * channels);
    for (std::size_t y = 0; y < film.window.height; ++y) {
        for (std::size_t x = 0; x < film.window.width; ++x) {
            const Color4f shown =
                displayed_pixel(film, film.window.x + x, film.window.y + y, gain, options.view);
            const bool visible = shown.a > 0.0F;
            const float scale = visible ? 1.0F / shown.a : 0.0F;
            for (const float c : {shown.r, shown.g, shown.b}) {
                samples.push_back(quantised<Sample>(srgb_from_linear(c * scale)));
            }
            samples.push_back(quantised<Sample>(visible ? shown.a : 0.0F));
        }
    }
    return samples;
}

}  // namespace

Diagnostics write_png(const Film& film, const std::filesystem::path& file,
                      const PngOptions& options) {
    if ((options.bits != 8 && options.bits != 16) || !std::isfinite(options.exposure)) {
        return {
            error(fmt::format("a PNG file cannot have {} bits per channel and an exposure of {}",
                              options.bits, options.exposure),
                  {}, "use 8 or 16 bits and a finite exposure")};
    }
    const PngSize size{film.window.width, film.window.height, channels};
    return options.bits == 8 ? write_png(to_samples<std::uint8_t>(film, options), size, file)
                             : write_png(to_samples<std::uint16_t>(film, options), size, file);
}

}  // namespace balcony::render
