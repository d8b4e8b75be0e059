// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rectangles and small text, drawn into an image.

#include <array>
#include <cstddef>
#include <string_view>

#include "balcony/image.hpp"

namespace balcony::analyse {

using Color = std::array<std::uint8_t, 3>;
inline constexpr Color white{255, 255, 255};
inline constexpr Color black{0, 0, 0};

/// An image to draw into; what lies outside is left out.
class Bitmap {
public:
    Bitmap(std::size_t width, std::size_t height, const Color& background);

    [[nodiscard]] std::size_t width() const { return image_.width; }
    [[nodiscard]] std::size_t height() const { return image_.height; }

    void fill(std::size_t x, std::size_t y, std::size_t width, std::size_t height,
              const Color& color);

    /// Writes one line of ASCII with its upper left corner at (x, y). A dot is `size` pixels wide;
    /// other characters show as question marks.
    void write(std::size_t x, std::size_t y, std::string_view text, const Color& color,
               std::size_t size = 1);

    /// The width and the height in pixels of a line of text.
    [[nodiscard]] static std::size_t text_width(std::string_view text, std::size_t size = 1);
    [[nodiscard]] static std::size_t text_height(std::size_t size = 1);

    [[nodiscard]] Image take() { return std::move(image_); }

private:
    Image image_;
};

}  // namespace balcony::analyse
