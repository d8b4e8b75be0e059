// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <stop_token>

#include "balcony/film.hpp"
#include "balcony/render.hpp"
#include "render/job/picture_rays.hpp"
#include "render/tracing/bright_patches.hpp"
#include "render/tracing/scene_tracer.hpp"

namespace balcony::render {

/// The parts of surfaces that lamps light much more than what surfaces see on average. Null if
/// there are none. They depend on the whole picture, not on the film's window. After a stop, they
/// are of no use.
[[nodiscard]] std::shared_ptr<const BrightPatches> bright_patches(const TracedScene& traced,
                                                                  PictureRays& rays,
                                                                  const Film& film,
                                                                  const Settings& settings,
                                                                  const std::stop_token& stop);

}  // namespace balcony::render
