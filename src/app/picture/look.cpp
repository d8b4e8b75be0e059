// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/picture/look.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace balcony::app {

namespace {

// Pixels without light do not count, so there are few, with many samples.
constexpr double look_pixels = 64.0 * 36.0;
constexpr std::size_t look_samples = 64;

render::FilmLayout small_layout(const render::FilmLayout& layout) {
    const double aspect = static_cast<double>(layout.width) / static_cast<double>(layout.height);
    const double width = std::clamp(std::round(std::sqrt(look_pixels * aspect)), 1.0, look_pixels);
    return {.width = static_cast<std::size_t>(width),
            .height = static_cast<std::size_t>(std::round(look_pixels / width)),
            .data_layers = false};
}

}  // namespace

Result<Look> look_at(const camera::Picture& picture, const render::Renderer& renderer,
                     render::Settings settings, const render::FilmLayout& layout,
                     const std::stop_token& stop) {
    settings.samples = look_samples;
    settings.sampling.seed = 0;
    settings.sampling.noise = 0.0;
    Result<render::Film> film = render::make_film(small_layout(layout));
    if (!film) {
        return std::move(film.diagnostics);
    }
    Result<render::Summary> summary = render::render(renderer, picture, settings, *film, {}, stop);
    if (!summary) {
        return std::move(summary.diagnostics);
    }
    return {Look{render::automatic_exposure(*film), std::move(*summary)},
            std::move(summary.diagnostics)};
}

}  // namespace balcony::app
