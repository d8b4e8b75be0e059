// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <stop_token>

#include "balcony/film.hpp"
#include "balcony/render.hpp"
#include "render/job/picture_rays.hpp"
#include "render/tracing/scene_tracer.hpp"
#include "shading/lights/distant_visibility.hpp"

namespace balcony::render {

/// What of the distant light reaches the places that a picture shows, and those that these see.
/// Null where most of it does: in the open. It depends on the whole picture, not on the film's
/// window. After a stop, it is of no use.
[[nodiscard]] std::shared_ptr<const DistantVisibility> distant_visibility(
    const TracedScene& traced, PictureRays& rays, const Film& film, const Settings& settings,
    const std::stop_token& stop);

}  // namespace balcony::render
