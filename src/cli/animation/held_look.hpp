// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>

#include "balcony/picture.hpp"
#include "cli/loaded_picture.hpp"
#include "cli/picture_run.hpp"
#include "cli/report/render_report.hpp"

namespace balcony::cli {

/// Sets what a render chooses by looking at its picture (the exposure, if the frames have one, the
/// ambient light, the light of a scene without any) to what suits the picture at the time of the
/// request, so that it is the same in all frames. It is measured on a small picture, which is the
/// same whatever part of the animation is rendered. False if that fails, as the report says.
[[nodiscard]] bool hold_look(Request& request, const Loaded& loaded, const camera::Picture& picture,
                             const render::FilmLayout& layout, bool is_displayed,
                             RenderReport& outcome, const std::stop_token& stop);

}  // namespace balcony::cli
