// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A camera that goes once round a scene.

#include "balcony/animation.hpp"
#include "balcony/picture.hpp"
#include "balcony/probe.hpp"

namespace balcony::app {

/// One turn about the vertical axis through the middle of the scene's bounds, from the first of the
/// frames on. After the last one, the next would be the first again.
[[nodiscard]] camera::Turn turn_of(const render::SceneExtent& extent,
                                   const AnimationRequest& request, const FrameNumbers& frames);

/// A perspective camera, slightly above the middle of the scene, that shows all of it from every
/// side, in a picture of this aspect.
[[nodiscard]] Result<camera::Picture> turntable_picture(const scene::Scene& scene,
                                                        const render::SceneExtent& extent,
                                                        double aspect);

}  // namespace balcony::app
