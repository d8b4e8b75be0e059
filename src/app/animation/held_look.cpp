// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/animation/held_look.hpp"

#include <algorithm>
#include <cmath>

#include "app/words.hpp"

namespace balcony::app {

bool hold_look(Request& request, Loaded& loaded, const camera::Picture& picture,
               const render::FilmLayout& layout, bool is_displayed, Diagnostics& found,
               const std::stop_token& stop) {
    if (request.exposure && loaded.settings.ambient) {
        return true;
    }
    constexpr double width = 256.0;
    constexpr std::size_t samples = 4;
    const double scale = std::min(1.0, width / static_cast<double>(layout.width));
    const auto side = [scale](std::size_t pixels) {
        return static_cast<std::size_t>(
            std::max(1.0, std::round(scale * static_cast<double>(pixels))));
    };
    render::Settings settings = loaded.settings;
    settings.samples = samples;
    settings.sampling.noise = 0.0;
    Result<render::Film> film = render::make_film(
        {.width = side(layout.width), .height = side(layout.height), .data_layers = false});
    if (!film) {
        add(found, film.diagnostics);
        return false;
    }
    const Result<render::Summary> summary =
        render::render(*loaded.renderer, picture, settings, *film, {}, stop);
    if (!summary) {
        add(found, summary.diagnostics);
        return false;
    }
    render::Settings& held = loaded.settings;
    if (!request.exposure && (is_displayed || held.sampling.noise > 0.0)) {
        request.exposure = render::automatic_exposure(*film);
        held.sampling.white = std::exp2(-*request.exposure);
    }
    held.light.substitute = summary->substitute;
    const bool has_ambient_light = summary->light.empty();
    if (has_ambient_light && !held.ambient) {
        held.ambient = summary->ambient;
    }
    return true;
}

}  // namespace balcony::app
