// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/draw/legend.hpp"

#include <algorithm>

namespace balcony::analyse {

namespace {

constexpr std::size_t legend_margin = 8;
constexpr std::size_t line_height = 7 * legend_text_size + legend_margin;
constexpr std::size_t bar_height = 12;

void write_scale(const ColorScale& scale, std::size_t y, Bitmap& bitmap) {
    const std::size_t width = bitmap.width() - 2 * legend_margin;
    for (std::size_t x = 0; x < width; ++x) {
        const double s = (static_cast<double>(x) + 0.5) / static_cast<double>(width);
        bitmap.fill(legend_margin + x, y, 1, bar_height, sequential_color(s));
    }
    y += bar_height;
    std::size_t free = 0;
    for (const ColorScale::Tick& tick : scale.ticks()) {
        const auto x = legend_margin + static_cast<std::size_t>(scale.position(tick.value) *
                                                                static_cast<double>(width - 1));
        bitmap.fill(x, y, 1, legend_margin / 2, black);
        const std::size_t text_width = Bitmap::text_width(tick.text, legend_text_size);
        const std::size_t half = text_width / 2;
        const std::size_t left = std::min(x > half ? x - half : 0, bitmap.width() - text_width);
        if (left >= free) {
            bitmap.write(left, y + legend_margin / 2 + 2, tick.text, black, legend_text_size);
            free = left + text_width + 2 * legend_margin;
        }
    }
}

}  // namespace

std::size_t height_of(const Legend& legend) {
    return legend_margin + line_height +
           (legend.scale ? bar_height + legend_margin + line_height : 0) +
           (legend.swatches.empty() ? 0 : line_height);
}

void write_legend(const Legend& legend, std::size_t top, Bitmap& bitmap) {
    std::size_t y = top + legend_margin;
    bitmap.write(legend_margin, y, legend.title, black, legend_text_size);
    y += line_height;
    if (legend.scale) {
        write_scale(*legend.scale, y, bitmap);
        y += bar_height + legend_margin + line_height;
    }
    std::size_t x = legend_margin;
    for (const Swatch& swatch : legend.swatches) {
        const std::size_t side = Bitmap::text_height(legend_text_size);
        bitmap.fill(x, y, side, side, swatch.color);
        bitmap.write(x + side + legend_margin, y, swatch.meaning, black, legend_text_size);
        x += side + 4 * legend_margin + Bitmap::text_width(swatch.meaning, legend_text_size);
    }
}

}  // namespace balcony::analyse
