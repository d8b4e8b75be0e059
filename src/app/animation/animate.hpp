// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Animations of a scene that is loaded.

#include <stop_token>

#include "app/inputs/loaded.hpp"
#include "balcony/animation.hpp"
#include "balcony/picture.hpp"

namespace balcony::app {

/// Renders what is not finished yet of an animation, and makes its film. The scene is loaded for
/// the time of frame 1, which the settings have, and the picture is the one to render then; the
/// scene is moved along.
void render_frames(const AnimationRequest& animation, Loaded& loaded, camera::Picture picture,
                   const Observer& observer, const std::stop_token& stop, AnimationReport& report);

/// After a stop, makes the film of the frames that were rendered. Without any, nothing is left.
void end_film(const AnimationRequest& animation, const Observer& observer, AnimationReport& report);

}  // namespace balcony::app
