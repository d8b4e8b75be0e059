// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/layer_values.hpp"

#include <fmt/format.h>

#include "base/parallel_for.hpp"
#include "film/files/exr_channels.hpp"
#include "film/sums/layer_rows.hpp"

namespace balcony::render {

namespace {

LayerValues values_of(const Film& film, std::size_t channels, decltype(ChannelGroup::read) read) {
    LayerValues made{channels, std::vector<float>(film.window.size() * channels)};
    parallel_for(film.window.height, [&](std::size_t row) {
        const std::size_t y = film.window.y + row;
        for (std::size_t x = film.window.x; x < film.window.x + film.window.width; ++x) {
            read(film, x, y, made.values.data() + film.index(x, y) * channels);
        }
    });
    return made;
}

}  // namespace

Result<LayerValues> layer_values(const Film& film, LayerId layer) {
    const LayerRow& row = layer_rows()[static_cast<std::size_t>(layer)];
    if (!film.layer_set.contains(layer) || !row.complete(film)) {
        return error(Kind::usage, fmt::format("the picture has no layer '{}'", row.info.name),
                     fmt::format("render it with --layers default,{}", row.info.name));
    }
    return values_of(film, row.info.channels.size() * row.info.levels, row.read);
}

LayerValues color_values(const Film& film) {
    const ChannelGroup color = channel_groups(film).front();
    return values_of(film, color.names.size(), color.read);
}

}  // namespace balcony::render
