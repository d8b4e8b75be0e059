// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/draw/bitmap.hpp"

#include <algorithm>

#include "analyse/draw/bitmap_font.hpp"

namespace balcony::analyse {

namespace {

constexpr std::size_t advance = glyph_width + 1;

}  // namespace

Bitmap::Bitmap(std::size_t width, std::size_t height, const Color& background)
    : image_{width, height, std::vector<std::uint8_t>(3 * width * height)} {
    fill(0, 0, width, height, background);
}

void Bitmap::fill(std::size_t x, std::size_t y, std::size_t width, std::size_t height,
                  const Color& color) {
    for (std::size_t j = y; j < std::min(y + height, image_.height); ++j) {
        for (std::size_t i = x; i < std::min(x + width, image_.width); ++i) {
            std::copy(
                color.begin(), color.end(),
                image_.samples.begin() + static_cast<std::ptrdiff_t>(3 * (j * image_.width + i)));
        }
    }
}

void Bitmap::write(std::size_t x, std::size_t y, std::string_view text, const Color& color,
                   std::size_t size) {
    for (const char character : text) {
        const Glyph& rows = glyph(character);
        for (std::size_t j = 0; j < glyph_height; ++j) {
            for (std::size_t i = 0; i < glyph_width; ++i) {
                if ((rows[j] >> (glyph_width - 1 - i) & 1) != 0) {
                    fill(x + i * size, y + j * size, size, size, color);
                }
            }
        }
        x += advance * size;
    }
}

std::size_t Bitmap::text_width(std::string_view text, std::size_t size) {
    return text.empty() ? 0 : (advance * text.size() - 1) * size;
}

std::size_t Bitmap::text_height(std::size_t size) { return glyph_height * size; }

}  // namespace balcony::analyse
