// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/film.hpp"

#include <algorithm>
#include <new>
#include <span>
#include <type_traits>

#include <fmt/format.h>

#include "balcony/tiled_file.hpp"
#include "base/memory.hpp"
#include "film/sums/film_arrays.hpp"
#include "film/sums/layer_rows.hpp"

namespace balcony::render {

namespace {

// All layers that the film stores.
LayerSet layers_of(const FilmLayout& layout) {
    LayerSet wanted = layout.layers;
    if (layout.data_layers) {
        wanted.insert(default_layers());
    }
    wanted = with_needs(wanted);
    if (layout.second_moment) {
        wanted.insert(LayerId::variance);
    }
    return wanted;
}

bool at_center(const LayerInfo& layer) {
    return layer.sampling == LayerSampling::center && layer.bytes > 0;
}

Diagnostics check(const FilmLayout& layout, const Region& window) {
    Diagnostics found;
    const auto check_side = [&](std::size_t side, std::string_view what) {
        if (side < 1 || side > max_film_side) {
            found.push_back(error(Kind::usage,
                                  fmt::format("the picture's {} {} is out of range", what, side),
                                  fmt::format("give a number from 1 to {}", max_film_side)));
        }
    };
    check_side(layout.width, "width");
    check_side(layout.height, "height");
    if (!found.empty()) {
        return found;
    }
    if (!is_part(window, layout.width, layout.height)) {
        return {error(Kind::usage,
                      fmt::format("the region of {} x {} pixels at ({}, {}) is not part of the "
                                  "picture of {} x {} pixels",
                                  window.width, window.height, window.x, window.y, layout.width,
                                  layout.height))};
    }
    const double bytes = film_bytes(layout);
    const double memory = physical_memory();
    if (memory > 0.0 && bytes > memory) {
        return {error(
            Kind::environment,
            fmt::format("a film of {} x {} pixels needs {:.1f} GB, but this machine has {:.1f} GB",
                        window.width, window.height, bytes / 1e9, memory / 1e9),
            "make the picture smaller, omit layers, or write an .exr file, in bands")};
    }
    return {};
}

void allocate_layers(Film& film, LayerSet stored) {
    const auto is_stored = [&](const LayerRow& row) { return stored.contains(row.info.id); };
    if (std::any_of(layer_rows().begin(), layer_rows().end(),
                    [&](const LayerRow& row) { return is_stored(row) && at_center(row.info); })) {
        film.layers.emplace().valid.assign(film.window.size(), 0);
    }
    for (const LayerRow& row : layer_rows()) {
        if (is_stored(row)) {
            row.allocate(film);
        }
    }
}

Color4f without_alpha(const Color3f& color) { return {color.x, color.y, color.z, 0.0F}; }

// The number of tiles of a grid from 0 that a range of pixels touches.
std::size_t tiles_touched(std::size_t begin, std::size_t length, std::size_t side) {
    return length == 0 ? 0 : (begin + length - 1) / side - begin / side + 1;
}

}  // namespace

bool is_part(const Region& window, std::size_t width, std::size_t height) {
    const auto within = [](std::size_t begin, std::size_t length, std::size_t side) {
        return length >= 1 && begin < side && length <= side - begin;
    };
    return within(window.x, window.width, width) && within(window.y, window.height, height);
}

Diagnostics check_sizes(const Film& film) {
    const auto fits = [&film](const auto& values) {
        return values.empty() || values.size() == film.window.size();
    };
    if (is_part(film.window, film.width, film.height) && !film.sum.empty() && fits(film.sum) &&
        fits(film.sum_of_squares) && fits(film.display) && fits(film.mirrored) &&
        fits(film.noisy) && fits(film.pixel_passes) && fits(film.first_half) &&
        film.passes.size() == film.tile_count()) {
        return {};
    }
    return {error(Kind::internal, "the film's vectors do not have the size of its window",
                  "create the film with make_film()")};
}

double film_bytes(const FilmLayout& layout) {
    const Region window = layout.window.value_or(Region{0, 0, layout.width, layout.height});
    const LayerSet stored = layers_of(layout);
    std::size_t pixel_bytes = sizeof(Color4d);
    for (const LayerInfo& layer : layers()) {
        pixel_bytes += stored.contains(layer.id) ? layer.bytes : 0;
    }
    return static_cast<double>(window.width) * static_cast<double>(window.height) *
           static_cast<double>(pixel_bytes);
}

std::size_t Film::tile_columns() const { return tiles_touched(window.x, window.width, tile_width); }

std::size_t Film::tile_rows() const { return tiles_touched(window.y, window.height, tile_height); }

Region Film::tile(std::size_t index) const {
    if (index >= tile_count()) {
        return {};
    }
    const std::size_t x = (window.x / tile_width + index % tile_columns()) * tile_width;
    const std::size_t y = (window.y / tile_height + index / tile_columns()) * tile_height;
    return {x, y, std::min(tile_width, width - x), std::min(tile_height, height - y)};
}

std::size_t Film::tile_of(std::size_t x, std::size_t y) const {
    return (y / tile_height - window.y / tile_height) * tile_columns() + x / tile_width -
           window.x / tile_width;
}

Color4f Film::surface_light(std::size_t x, std::size_t y) const { return mean(sum, x, y); }

Color4f Film::light(std::size_t x, std::size_t y) const {
    return with_mirrored(surface_light(x, y), x, y);
}

Color4f Film::rendered_light(std::size_t x, std::size_t y) const {
    return noisy.empty() ? light(x, y) : with_mirrored(mean(noisy, x, y), x, y);
}

Color4f Film::with_mirrored(const Color4f& own, std::size_t x, std::size_t y) const {
    return background ? own : own + mean(mirrored, x, y) * without_alpha(ambient);
}

Color4f Film::display_color(std::size_t x, std::size_t y) const {
    const Color4f own = mean(display, x, y);
    return background ? own + mean(mirrored, x, y) * without_alpha(*background) : own;
}

Color4f Film::pixel(std::size_t x, std::size_t y) const {
    return light(x, y) + display_color(x, y);
}

Color4f Film::mean(const std::vector<Color4d>& sums, std::size_t x, std::size_t y) const {
    const std::uint32_t count = samples(x, y);
    if (count == 0 || sums.empty()) {
        return Color4f(0.0F);
    }
    const Color4d mean = sums[index(x, y)] / static_cast<double>(count);
    return {static_cast<float>(mean.r), static_cast<float>(mean.g), static_cast<float>(mean.b),
            static_cast<float>(mean.a)};
}

Color4d Film::variance(std::size_t x, std::size_t y) const {
    const auto n = static_cast<double>(samples(x, y));
    if (n < 2.0 || sum_of_squares.empty()) {
        return Color4d(0.0);
    }
    const Color4d& total = (noisy.empty() ? sum : noisy)[index(x, y)];
    const Color4d& squares = sum_of_squares[index(x, y)];
    const auto channel = [n](double s, double s2) {
        return std::max((s2 - s * s / n) / (n - 1.0), 0.0);
    };
    return {channel(total.r, squares.r), channel(total.g, squares.g), channel(total.b, squares.b),
            channel(total.a, squares.a)};
}

void begin_anew(Film& film, const Region& window) {
    std::vector<const LayerRow*> stored;
    for (const LayerRow& row : layer_rows()) {
        if (row.complete(film)) {
            stored.push_back(&row);
        }
    }
    film.window = window;
    for_each_array(film, [&](auto& array) {
        using Array = std::decay_t<decltype(array)>;
        if constexpr (!std::is_same_v<Array, std::span<double>>) {
            if (!array.empty()) {
                array.assign(window.size(), zero<typename Array::value_type>());
            }
        }
    });
    for (const LayerRow* row : stored) {
        row->allocate(film);
    }
    film.passes.assign(film.tile_count(), 0);
}

Result<Film> make_film(const FilmLayout& layout) {
    const Region window = layout.window.value_or(Region{0, 0, layout.width, layout.height});
    if (Diagnostics found = check(layout, window); !found.empty()) {
        return found;
    }
    try {
        Film film;
        film.width = layout.width;
        film.height = layout.height;
        film.window = window;
        film.sum.assign(window.size(), Color4d(0.0));
        film.layer_set = layout.layers;
        if (layout.data_layers) {
            film.layer_set.insert(default_layers());
        }
        allocate_layers(film, layers_of(layout));
        film.passes.assign(film.tile_count(), 0);
        return film;
    } catch (const std::bad_alloc&) {
        return error(Kind::environment, "out of memory while creating the film",
                     "make the picture smaller, or omit the data layers");
    }
}

}  // namespace balcony::render
