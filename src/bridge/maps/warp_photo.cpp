// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cstdint>
#include <utility>

#include "balcony/display_file.hpp"
#include "balcony/images.hpp"
#include "balcony/output_file.hpp"
#include "balcony/photo_arrays.hpp"
#include "balcony/progress.hpp"
#include "balcony/st_maps.hpp"
#include "bridge/maps/map_rows.hpp"
#include "bridge/maps/photo.hpp"

namespace balcony::bridge {

namespace {

// Linear light, premultiplied. The photo must outlive it.
PixelOfPlace light_of(const images::FilteredImage& photo) {
    return [&photo](const SourcePlace& place) {
        std::array<float, 4> light{};
        if (place.coverage > 0.0) {
            light = photo.mean(place.st, place.st_by_x, place.st_by_y);
            for (float& value : light) {
                value *= static_cast<float>(place.coverage);
            }
        }
        return light;
    };
}

Diagnostics write_display(const std::vector<float>& values, const StMap& map, bool deep,
                          const render::DisplayFormat& format, double dpi,
                          const std::filesystem::path& file) {
    const render::DisplaySize size{map.width(), map.height(), format.has_alpha ? 4U : 3U, dpi};
    const bool wide = (deep ? format.max_bits : format.bits) > 8;
    const auto bytes =
        wide
            ? render::encode(display_samples<std::uint16_t>(values, format.has_alpha), size, format)
            : render::encode(display_samples<std::uint8_t>(values, format.has_alpha), size, format);
    return bytes ? write_whole(file, std::span(*bytes)) : bytes.diagnostics;
}

}  // namespace

StMapWritten warp_photo(const StMap& map, const Photo& photo, const std::filesystem::path& file,
                        double dpi, const std::stop_token& stop) {
    const Photo::Pixels& pixels = photo.pixels();
    const auto filtered =
        images::FilteredImage::make({pixels.width, pixels.height, pixels.values}, map.closes());
    if (!filtered) {
        return {.problems = filtered.diagnostics};
    }
    const PixelOfPlace pixel = light_of(**filtered);
    const render::DisplayFormat* const format = render::display_format(file);
    if (format == nullptr) {
        return write_map_to_exr(map, file, pixel, stop);
    }
    if (Diagnostics found = render::check_size(*format, map.width(), map.height());
        has_errors(found)) {
        return {.problems = std::move(found)};
    }
    const MapPixels made = map_pixels(map, pixel, stop);
    StMapWritten written{.valid = made.valid, .complete = made.complete};
    if (written.complete) {
        written.problems = write_display(made.values, map, photo.is_deep(), *format, dpi, file);
    }
    return written;
}

Result<WarpedPixels> warped_pixels(const StMap& map, const Photo& photo,
                                   const std::stop_token& stop) {
    const Photo::Pixels& pixels = photo.pixels();
    const auto filtered =
        images::FilteredImage::make({pixels.width, pixels.height, pixels.values}, map.closes());
    if (!filtered) {
        return filtered.diagnostics;
    }
    MapPixels made = map_pixels(map, light_of(**filtered), stop);
    if (!made.complete) {
        return stopped();
    }
    return pixels.linear ? WarpedPixels(std::move(made.values))
           : pixels.deep ? WarpedPixels(display_samples<std::uint16_t>(made.values, true))
                         : WarpedPixels(display_samples<std::uint8_t>(made.values, true));
}

}  // namespace balcony::bridge
