// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/animation/held_look.hpp"

#include <cmath>

#include "app/picture/findings.hpp"
#include "app/picture/look.hpp"
#include "app/words.hpp"

namespace balcony::app {

bool hold_look(Request& request, Loaded& loaded, const camera::Picture& picture,
               const render::FilmLayout& layout, bool is_displayed, Diagnostics& found,
               const std::stop_token& stop) {
    if (request.exposure && loaded.settings.ambient) {
        return true;
    }
    if (add(found,
            pass_starts(request.inside, picture, {layout.width, layout.height}, loaded, stop))) {
        return false;
    }
    const Result<Look> look = look_at(picture, *loaded.renderer, loaded.settings, layout, stop);
    if (add(found, look.diagnostics)) {
        return false;
    }
    render::Settings& held = loaded.settings;
    if (!request.exposure && (is_displayed || held.sampling.noise > 0.0)) {
        request.exposure = look->exposure;
        held.sampling.white = std::exp2(-*request.exposure);
    }
    held.light.substitute = look->summary.substitute;
    const bool has_ambient_light = look->summary.light.empty();
    if (has_ambient_light && !held.ambient) {
        held.ambient = look->summary.ambient;
    }
    return true;
}

}  // namespace balcony::app
