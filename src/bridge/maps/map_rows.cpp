// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/maps/map_rows.hpp"

#include "balcony/output_file.hpp"
#include "bridge/maps/exr_rows.hpp"

namespace balcony::bridge {

MapRows map_rows(const StMap& map, const RowSpan& span, const PixelOfPlace& pixel) {
    MapRows rows{span};
    std::vector<SourcePlace> places;
    map.run(span.first, span.count, places);
    rows.values.reserve(4 * places.size());
    for (const SourcePlace& place : places) {
        rows.valid += place.valid ? 1 : 0;
        const std::array<float, 4> values = pixel(place);
        rows.values.insert(rows.values.end(), values.begin(), values.end());
    }
    return rows;
}

MapPixels map_pixels(const StMap& map, const PixelOfPlace& pixel, const std::stop_token& stop) {
    MapPixels made;
    made.complete = run_in_order<MapRows>(
        map.width(), map.height(), [&](const RowSpan& span) { return map_rows(map, span, pixel); },
        [&](const MapRows& rows) {
            made.valid += rows.valid;
            made.values.insert(made.values.end(), rows.values.begin(), rows.values.end());
            return true;
        },
        stop);
    return made;
}

StMapWritten write_map_to_exr(const StMap& map, const std::filesystem::path& file,
                              const PixelOfPlace& pixel, const std::stop_token& stop) {
    OutputFile output(file);
    if (!output.stream()) {
        return {.problems = {output.failure()}};
    }
    StMapWritten written;
    ExrRows exr(output.stream(), map.width(), map.height(), {"R", "G", "B", "A"});
    written.complete = run_in_order<MapRows>(
        map.width(), map.height(), [&](const RowSpan& span) { return map_rows(map, span, pixel); },
        [&](const MapRows& rows) {
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

}  // namespace balcony::bridge
