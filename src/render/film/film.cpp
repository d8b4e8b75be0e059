// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/film/film.hpp"

#include <limits>

namespace balcony::render {

namespace {

constexpr std::size_t layer_bytes = sizeof(float) + 4 * sizeof(V3f) + sizeof(Color3f) +
                                    sizeof(std::uint32_t) + sizeof(V2f) + sizeof(std::uint8_t) +
                                    sizeof(std::uint16_t);

}  // namespace

double film_bytes(const Settings& settings) {
    const std::size_t pixel_bytes =
        sizeof(Color4f) + sizeof(std::uint32_t) + (settings.data_layers ? layer_bytes : 0);
    return static_cast<double>(settings.width) * static_cast<double>(settings.height) *
           static_cast<double>(pixel_bytes);
}

Film make_film(const Settings& settings, const scene::Scene& scene) {
    const std::size_t pixels = settings.width * settings.height;
    Film film;
    film.width = settings.width;
    film.height = settings.height;
    film.sum.assign(pixels, Color4f(0.0F));
    film.samples.assign(pixels, 0);
    if (settings.data_layers) {
        DataLayers& layers = film.layers.emplace();
        layers.ray_length.assign(pixels, std::numeric_limits<float>::infinity());
        layers.position.assign(pixels, V3f(0.0F));
        layers.normal.assign(pixels, V3f(0.0F));
        layers.albedo.assign(pixels, Color3f(0.0F));
        layers.object.assign(pixels, 0);
        layers.origin.assign(pixels, V3f(0.0F));
        layers.direction.assign(pixels, V3f(0.0F));
        layers.parameters.assign(pixels, V2f(0.0F));
        layers.valid.assign(pixels, 0);
        layers.layer.assign(pixels, 0);
    }
    film.objects.reserve(scene.objects.size());
    for (const scene::Object& object : scene.objects) {
        film.objects.push_back(object.name);
    }
    return film;
}

Color4f Film::pixel(std::size_t x, std::size_t y) const {
    const std::size_t i = y * width + x;
    return samples[i] > 0 ? sum[i] / static_cast<float>(samples[i]) : Color4f(0.0F);
}

}  // namespace balcony::render
