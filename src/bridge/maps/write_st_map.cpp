// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <utility>

#include <fmt/format.h>

#include "balcony/output_file.hpp"
#include "balcony/photo_arrays.hpp"
#include "balcony/progress.hpp"
#include "balcony/st_maps.hpp"
#include "bridge/maps/map_rows.hpp"

namespace balcony::bridge {

namespace {

std::array<float, 4> pixel_of(const SourcePlace& place) {
    const float there = place.valid ? 1.0F : 0.0F;
    return {there * static_cast<float>(place.st.x), there * static_cast<float>(place.st.y), 0.0F,
            there};
}

}  // namespace

Diagnostics check_st_map_file(const std::filesystem::path& file) {
    if (ending_of(file) != ".exr") {
        return {error(
            Kind::usage,
            fmt::format("'{}' is no name for an STMap, whose numbers need floats", file.string()),
            "use a file name that ends in .exr")};
    }
    return OutputFile::check(file);
}

StMapWritten write_st_map(const StMap& map, const std::filesystem::path& file,
                          const std::stop_token& stop) {
    return write_map_to_exr(map, file, pixel_of, stop);
}

Result<std::vector<float>> st_map_pixels(const StMap& map, const std::stop_token& stop) {
    MapPixels made = map_pixels(map, pixel_of, stop);
    return made.complete ? Result<std::vector<float>>(std::move(made.values))
                         : Result<std::vector<float>>(stopped());
}

}  // namespace balcony::bridge
