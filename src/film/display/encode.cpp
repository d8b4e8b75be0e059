// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "balcony/display_file.hpp"
#include "balcony/display_pixels.hpp"
#include "balcony/film.hpp"
#include "base/parallel_for.hpp"
#include "film/display/displayed_pixel.hpp"
#include "film/sums/film_arrays.hpp"

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

// Rounded up or down by a threshold from 0 to 1; 0.5 is the nearest.
template <class Sample>
Sample quantised(float value, float threshold = 0.5F) {
    constexpr auto maximum = static_cast<float>(std::numeric_limits<Sample>::max());
    return static_cast<Sample>(std::clamp(value, 0.0F, 1.0F) * maximum + threshold);
}

// A pattern of thresholds whose values are evenly distributed in every small area: the R2 sequence
// over the plane (Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018).
float threshold(std::size_t x, std::size_t y, std::size_t channel) {
    constexpr double along_x = 0.7548776662466927;
    constexpr double along_y = 0.5698402909980532;
    // Colours whose channels change together would show more than a channel alone.
    constexpr double along_channels = 1.0 / 3.0;
    // More than the rounding of a colour that has an exact level.
    constexpr double margin = 1.0 / 1024.0;
    const double value = along_x * static_cast<double>(x) + along_y * static_cast<double>(y) +
                         along_channels * static_cast<double>(channel);
    return static_cast<float>(std::clamp(value - std::floor(value), margin, 1.0 - margin));
}

template <class Sample>
std::vector<Sample> to_samples(const Film& film, const DisplayOptions& options, bool with_alpha) {
    const auto gain = static_cast<float>(std::exp2(options.exposure));
    const bool dither = options.dither && sizeof(Sample) == 1;
    const Region& window = film.window;
    const std::size_t channels = with_alpha ? 4 : 3;
    std::vector<Sample> samples(window.size() * channels);
    const auto convert_row = [&](std::size_t row) {
        Sample* sample = &samples[row * window.width * channels];
        const std::size_t y = window.y + row;
        for (std::size_t x = window.x; x < window.x + window.width; ++x) {
            const auto [shown, lit] = displayed_pixel(film, x, y, gain, options.view);
            const bool visible = shown.a > 0.0F;
            // Without alpha, the picture is in front of black.
            const float scale = !visible ? 0.0F : with_alpha ? 1.0F / shown.a : 1.0F;
            const float colors[] = {shown.r, shown.g, shown.b};
            for (std::size_t c = 0; c < 3; ++c) {
                *sample++ = quantised<Sample>(srgb_from_linear(colors[c] * scale),
                                              dither && lit ? threshold(x, y, c) : 0.5F);
            }
            if (with_alpha) {
                *sample++ = quantised<Sample>(visible ? shown.a : 0.0F);
            }
        }
    };
    parallel_for(window.height, convert_row);
    return samples;
}

}  // namespace

std::vector<std::uint8_t> display_pixels(const Film& film, const DisplayOptions& options) {
    return check_sizes(film).empty() ? to_samples<std::uint8_t>(film, options, false)
                                     : std::vector<std::uint8_t>();
}

Result<std::vector<std::uint8_t>> encode(const Film& film, const DisplayFormat& format,
                                         const DisplayOptions& options) {
    if (Diagnostics found = check_sizes(film); !found.empty()) {
        return found;
    }
    const int bits = options.bits.value_or(format.bits);
    if ((bits != 8 && bits != 16) || bits > format.max_bits || !std::isfinite(options.exposure)) {
        return error(Kind::usage,
                     fmt::format("a {} file cannot have {} bits per channel and an exposure of {}",
                                 format.extension, bits, options.exposure),
                     fmt::format("use 8{} bits and a finite exposure",
                                 format.max_bits == 16 ? " or 16" : ""));
    }
    const DisplaySize size{film.window.width, film.window.height, format.has_alpha ? 4U : 3U,
                           options.dpi};
    return bits == 8
               ? encode(to_samples<std::uint8_t>(film, options, format.has_alpha), size, format)
               : encode(to_samples<std::uint16_t>(film, options, format.has_alpha), size, format);
}

}  // namespace balcony::render
