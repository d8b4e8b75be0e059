// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>

#include "balcony/output_file.hpp"
#include "balcony/st_maps.hpp"
#include "bridge/maps/exr_rows.hpp"

namespace balcony::bridge {

namespace {

struct PlaceRows {
    RowSpan span;
    std::size_t valid = 0;
    std::vector<float> values;
};

PlaceRows place_rows(const StMap& map, const RowSpan& span) {
    PlaceRows rows{span, 0, {}};
    std::vector<SourcePlace> places;
    map.run(span.first, span.count, places);
    rows.values.reserve(4 * places.size());
    for (const SourcePlace& place : places) {
        rows.valid += place.valid ? 1 : 0;
        const float there = place.valid ? 1.0F : 0.0F;
        rows.values.insert(rows.values.end(),
                           {there * static_cast<float>(place.st.x),
                            there * static_cast<float>(place.st.y), 0.0F, there});
    }
    return rows;
}

}  // namespace

StMapWritten write_st_map(const StMap& map, const std::filesystem::path& file,
                          const std::stop_token& stop) {
    OutputFile output(file);
    if (!output.stream()) {
        return {.problems = {output.failure()}};
    }
    StMapWritten written;
    ExrRows exr(output.stream(), map.width(), map.height(), {"R", "G", "B", "A"});
    written.complete = run_in_order<PlaceRows>(
        map.width(), map.height(), [&map](const RowSpan& span) { return place_rows(map, span); },
        [&](const PlaceRows& rows) {
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
