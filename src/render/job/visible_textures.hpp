// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>

#include "balcony/film.hpp"
#include "render/job/picture_rays.hpp"
#include "render/tracing/scene_tracer.hpp"

namespace balcony::render {

/// Decodes the textures that do not fit into memory and that coarse rays of the picture see, on all
/// threads. Otherwise, the first ray that meets one decodes it, while others wait.
void read_visible_textures(const TracedScene& traced, PictureRays& rays, const Film& film,
                           double time, const std::stop_token& stop);

}  // namespace balcony::render
