// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pictures that are made of an STMap, some rows at a time.

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <vector>

#include "balcony/st_maps.hpp"
#include "bridge/maps/in_order.hpp"

namespace balcony::bridge {

/// Four numbers for each pixel of some rows: red, green, blue and alpha.
struct MapRows {
    RowSpan span;
    std::size_t valid = 0;  ///< The number of pixels whose centre the photo shows.
    std::vector<float> values{};
};

/// What a pixel becomes that shows a place of the photo.
using PixelOfPlace = std::function<std::array<float, 4>(const SourcePlace&)>;

[[nodiscard]] MapRows map_rows(const StMap& map, const RowSpan& span, const PixelOfPlace& pixel);

/// The pixels of all places.
struct MapPixels {
    std::size_t valid = 0;  ///< As MapRows::valid.
    bool complete = false;  ///< Otherwise a stop ended it.
    std::vector<float> values{};
};
[[nodiscard]] MapPixels map_pixels(const StMap& map, const PixelOfPlace& pixel,
                                   const std::stop_token& stop);

/// Writes the pixels of all places to an EXR file, which is complete or unchanged.
[[nodiscard]] StMapWritten write_map_to_exr(const StMap& map, const std::filesystem::path& file,
                                            const PixelOfPlace& pixel, const std::stop_token& stop);

}  // namespace balcony::bridge
