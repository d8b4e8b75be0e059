// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>

#include "app/inputs/loaded.hpp"
#include "balcony/app.hpp"

namespace balcony::app {

/// Renders a picture whose film is larger than the memory for it, band by band, and appends the
/// bands to its EXR file.
void render_in_bands(const Request& request, const Loaded& loaded, const camera::Picture& picture,
                     const render::FilmLayout& layout, const Observer& observer,
                     const std::stop_token& stop, Report& report);

}  // namespace balcony::app
