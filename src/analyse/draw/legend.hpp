// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyse/draw/bitmap.hpp"
#include "analyse/draw/color_scale.hpp"

namespace balcony::analyse {

/// A colour and its meaning.
struct Swatch {
    Color color;
    std::string meaning;
};

/// What the colours of a map mean.
struct Legend {
    std::string title;
    std::optional<ColorScale> scale;  ///< With round numbers below it.
    std::vector<Swatch> swatches;
};

/// Of its dots, in pixels.
inline constexpr std::size_t legend_text_size = 2;

/// In pixels, at any width.
[[nodiscard]] std::size_t height_of(const Legend& legend);
/// Writes it over the whole width, below the row `top`.
void write_legend(const Legend& legend, std::size_t top, Bitmap& bitmap);

}  // namespace balcony::analyse
