// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/film.hpp"
#include "render/job/picture_rays.hpp"
#include "render/tracing/scene_tracer.hpp"

namespace balcony::render {

/// The ambient radiance that follows the light of the scene, by the rule of Settings::ambient. It
/// depends on the whole picture, not on the film's window.
[[nodiscard]] Color3f ambient_of(const TracedScene& traced, PictureRays& rays, const Film& film,
                                 double time);

}  // namespace balcony::render
