// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Any bytes → the maps, images, tables and points that a camera file may name, or errors. What the
// bytes are is told by how they begin: an array of NumPy, the signature of an image, or else text.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <sstream>
#include <string>
#include <string_view>

#include "balcony/data.hpp"
#include "demand.hpp"

namespace {

using namespace balcony;

template <class T>
void demand_one_of_both(const Result<T>& result) {
    demand(result.value.has_value() != has_errors(result.diagnostics), "neither data nor error");
    (void)to_text(result.diagnostics);
}

void try_map(const Result<std::shared_ptr<const camera::PixelMap>>& read, std::size_t channels) {
    demand_one_of_both(read);
    if (!read) {
        return;
    }
    const camera::PixelMap& map = **read;
    const std::size_t pixels = map.width * map.height;
    demand(map.channels.size() == channels && map.valid.size() == pixels, "a map of another shape");
    for (const std::vector<double>& channel : map.channels) {
        demand(channel.size() == pixels, "a channel of another size");
        for (std::size_t i = 0; i < pixels; ++i) {
            demand(map.valid[i] == 0 || std::isfinite(channel[i]), "a number is not finite");
        }
    }
}

void try_image(const data::File& file) {
    try_map(data::read_ray_map(file), 6);
    try_map(data::read_st_map(file), 2);
    const auto grey = data::read_grey_image(file);
    demand_one_of_both(grey);
    demand(!grey || (*grey)->values.size() == (*grey)->width * (*grey)->height,
           "an image of another size");
}

void try_points(std::string_view bytes) {
    std::istringstream stream{std::string(bytes)};
    data::PointReader reader(stream, "points");
    for (bool more = true; more;) {
        const auto points = reader.next();
        demand_one_of_both(points);
        more = points && !points->empty();
    }
}

void try_table(const data::File& file) {
    const Result<data::NumberTable> table = data::read_table(file);
    demand_one_of_both(table);
    demand(!table || std::none_of(table->rows.begin(), table->rows.end(),
                                  [](const auto& row) { return row.empty(); }),
           "a row without numbers");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t count) {
    const std::span bytes(data, count);
    const std::string_view text(reinterpret_cast<const char*>(data), count);
    if (is_npy(text)) {
        try_map(data::read_ray_map(data::File::in_memory("fuzz.npy", "fuzz.npy", bytes)), 6);
        try_points(text);
    } else if (text.starts_with("\x76\x2f\x31")) {
        try_image(data::File::in_memory("fuzz.exr", "fuzz.exr", bytes));
    } else if (text.starts_with("\x89PNG")) {
        try_image(data::File::in_memory("fuzz.png", "fuzz.png", bytes));
    } else {
        try_table(data::File::in_memory("fuzz.csv", "fuzz.csv", bytes));
        try_points(text);
    }
    return 0;
}
