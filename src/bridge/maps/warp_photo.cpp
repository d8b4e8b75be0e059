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
#include "bridge/maps/exr_rows.hpp"
#include "bridge/maps/photo.hpp"

namespace balcony::bridge {

namespace {

/// Linear light, premultiplied, of some rows.
struct ColorRows {
    RowSpan span;
    std::size_t valid = 0;
    std::vector<float> values;
};

ColorRows color_rows(const StMap& map, const images::FilteredImage& photo, const RowSpan& span) {
    ColorRows rows{span, 0, {}};
    std::vector<SourcePlace> places;
    map.run(span.first, span.count, places);
    rows.values.reserve(4 * places.size());
    for (const SourcePlace& place : places) {
        rows.valid += place.valid ? 1 : 0;
        const std::array<float, 4> color = place.coverage > 0.0
                                               ? photo.mean(place.st, place.st_by_x, place.st_by_y)
                                               : std::array<float, 4>{};
        for (const float value : color) {
            rows.values.push_back(static_cast<float>(place.coverage) * value);
        }
    }
    return rows;
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
                          const render::DisplayFormat& format, const std::filesystem::path& file) {
    const render::DisplaySize size{map.width(), map.height(), format.has_alpha ? 4U : 3U};
    const bool wide = (deep ? format.max_bits : format.bits) > 8;
    const auto bytes =
        wide
            ? render::encode(display_samples<std::uint16_t>(values, format.has_alpha), size, format)
            : render::encode(display_samples<std::uint8_t>(values, format.has_alpha), size, format);
    return bytes ? write_whole(file, std::span(*bytes)) : bytes.diagnostics;
}

StMapWritten warp_to_exr(const StMap& map, const images::FilteredImage& photo,
                         const std::filesystem::path& file, const std::stop_token& stop) {
    OutputFile output(file);
    if (!output.stream()) {
        return {.problems = {output.failure()}};
    }
    StMapWritten written;
    ExrRows exr(output.stream(), map.width(), map.height(), {"R", "G", "B", "A"});
    written.complete = run_in_order<ColorRows>(
        map.width(), map.height(),
        [&](const RowSpan& span) { return color_rows(map, photo, span); },
        [&](const ColorRows& rows) {
            written.valid += rows.valid;
            return exr.write(rows.span, rows.values.data());
        },
        stop);
    if (!exr.finish()) {
        written.problems = {output.failure()};
    } else if (written.complete) {
        written.problems = output.commit();
    }
    return written;
}

}  // namespace

StMapWritten warp_photo(const StMap& map, const Photo& photo, const std::filesystem::path& file,
                        const std::stop_token& stop) {
    const Photo::Pixels& pixels = photo.pixels();
    const auto filtered =
        images::FilteredImage::make({pixels.width, pixels.height, pixels.values}, map.closes());
    if (!filtered) {
        return {.problems = filtered.diagnostics};
    }
    const images::FilteredImage& texture = **filtered;
    const render::DisplayFormat* const format = render::display_format(file);
    if (format == nullptr) {
        return warp_to_exr(map, texture, file, stop);
    }
    if (Diagnostics found = render::check_size(*format, map.width(), map.height());
        has_errors(found)) {
        return {.problems = std::move(found)};
    }
    StMapWritten written;
    std::vector<float> values;
    written.complete = run_in_order<ColorRows>(
        map.width(), map.height(),
        [&](const RowSpan& span) { return color_rows(map, texture, span); },
        [&](const ColorRows& rows) {
            written.valid += rows.valid;
            values.insert(values.end(), rows.values.begin(), rows.values.end());
            return true;
        },
        stop);
    if (written.complete) {
        written.problems = write_display(values, map, photo.is_deep(), *format, file);
    }
    return written;
}

}  // namespace balcony::bridge
