// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Photos and STMaps in memory instead of files.
//
//     photo_of(pixels, form) ─▶ warped_pixels(map, photo)        st_map_pixels(map)

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <variant>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/st_maps.hpp"

namespace balcony::bridge {

/// The form of numbers in memory, row by row from the top left.
struct PixelForm {
    std::size_t width = 0;
    std::size_t height = 0;
    std::size_t channels = 0;  ///< 1 is grey, 3 red, green and blue; 2 and 4 have alpha as well.
};

/// A photo of whole numbers, which are sRGB with straight alpha, or of floats, which are linear
/// light, multiplied by alpha. Floats that are not finite count as 0. The form fits the pixels.
[[nodiscard]] Photo photo_of(std::span<const std::uint8_t> pixels, const PixelForm& form);
[[nodiscard]] Photo photo_of(std::span<const std::uint16_t> pixels, const PixelForm& form);
[[nodiscard]] Photo photo_of(std::span<const float> pixels, const PixelForm& form);

/// Red, green, blue and alpha of pixels, row by row, in one of the forms that photo_of() takes.
using WarpedPixels =
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>>;

/// A photo as warp_photo() warps it, in numbers as it has them itself. A stop is an error of
/// Kind::interrupted.
[[nodiscard]] Result<WarpedPixels> warped_pixels(const StMap& map, const Photo& photo,
                                                 const std::stop_token& stop = {});

/// The numbers of the file that write_st_map() writes: red, green, blue and alpha of each pixel. A
/// stop is an error of Kind::interrupted.
[[nodiscard]] Result<std::vector<float>> st_map_pixels(const StMap& map,
                                                       const std::stop_token& stop = {});

}  // namespace balcony::bridge
