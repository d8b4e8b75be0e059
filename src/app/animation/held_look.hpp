// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>

#include "app/inputs/loaded.hpp"
#include "balcony/picture.hpp"

namespace balcony::app {

/// Sets what a render chooses by looking at its picture (the exposure, if the frames have one, the
/// ambient light, the light of a scene without any) to what suits the picture at the time of the
/// settings, so that it is the same in all frames, whatever part of the animation is rendered.
/// False if that fails, as the diagnostics say.
[[nodiscard]] bool hold_look(Request& request, Loaded& loaded, const camera::Picture& picture,
                             const render::FilmLayout& layout, bool is_displayed,
                             Diagnostics& found, const std::stop_token& stop);

}  // namespace balcony::app
