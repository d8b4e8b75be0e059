// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "balcony/display_file.hpp"
#include "balcony/images.hpp"
#include "balcony/output_file.hpp"
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

// sRGB with straight alpha, or over black in a format without alpha.
template <class Sample>
std::vector<Sample> display_samples(const std::vector<float>& values, bool alpha) {
    constexpr auto most = static_cast<float>(std::numeric_limits<Sample>::max());
    const auto sample = [](float value) {
        return static_cast<Sample>(std::lround(std::clamp(value, 0.0F, 1.0F) * most));
    };
    std::vector<Sample> samples;
    samples.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); i += 4) {
        const float opacity = values[i + 3];
        for (std::size_t k = 0; k < 3; ++k) {
            const float straight =
                alpha && opacity > 0.0F ? values[i + k] / opacity : values[i + k];
            samples.push_back(sample(display_from_linear(straight)));
        }
        if (alpha) {
            samples.push_back(sample(opacity));
        }
    }
    return samples;
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
    StMapWritten written;
    std::vector<float> values;
    written.complete = run_in_order<MapRows>(
        map.width(), map.height(), [&](const RowSpan& span) { return map_rows(map, span, pixel); },
        [&](const MapRows& rows) {
            written.valid += rows.valid;
            values.insert(values.end(), rows.values.begin(), rows.values.end());
            return true;
        },
        stop);
    if (written.complete) {
        written.problems = write_display(values, map, photo.is_deep(), *format, dpi, file);
    }
    return written;
}

}  // namespace balcony::bridge
