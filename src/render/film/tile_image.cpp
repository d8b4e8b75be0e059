// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/film/tile_image.hpp"

#include <algorithm>

namespace balcony::render {

namespace {

void write_data(DataLayers& layers, std::size_t at, const PointData& data) {
    layers.valid[at] = 1;
    layers.layer[at] = data.layer;
    layers.origin[at] = V3f(data.origin);
    layers.direction[at] = V3f(data.direction);
    layers.parameters[at] = data.parameters;
    const VisibleSurface& visible = data.visible;
    if (visible.any) {
        const double length = (Imath::V3d(visible.position) - data.origin).dot(data.direction);
        layers.ray_length[at] = static_cast<float>(std::max(length, 0.0));
        layers.position[at] = visible.position;
        layers.normal[at] = visible.normal;
        layers.albedo[at] = visible.albedo;
        layers.object[at] = visible.object;
    }
}

}  // namespace

void add_pass(Film& film, std::size_t tile, const TileImage& image) {
    const bool with_squares = !film.sum_of_squares.empty();
    const bool with_data = film.layers && !image.data.empty();
    for_each_pixel(image.region, [&](std::size_t i, std::size_t x, std::size_t y) {
        if (!film.window.contains(x, y)) {
            return;
        }
        const std::size_t at = film.index(x, y);
        const Color4d sample(image.light[i]);
        film.sum[at] += sample;
        if (with_squares) {
            film.sum_of_squares[at] += sample * sample;
        }
        if (!image.display.empty()) {
            film.display[at] += Color4d(image.display[i]);
        }
        if (!image.mirrored.empty()) {
            film.mirrored[at] += Color4d(image.mirrored[i]);
        }
        if (with_data && image.data[i].valid) {
            write_data(*film.layers, at, image.data[i]);
        }
    });
    ++film.passes[tile];
}

}  // namespace balcony::render
