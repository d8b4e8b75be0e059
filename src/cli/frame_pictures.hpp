// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>

#include "balcony/picture.hpp"
#include "balcony/render.hpp"
#include "balcony/scene.hpp"
#include "cli/options/render_options.hpp"

namespace balcony::cli {

/// Whether the options select a camera of the scene, or its default one, and cameras move.
[[nodiscard]] bool has_moving_camera(const RenderOptions& options, const scene::Scene& scene);

/// The picture at a time. A camera of the scene has one place, so that it is made anew, with the
/// turn of the picture.
[[nodiscard]] Result<camera::Picture> picture_at(const RenderOptions& options,
                                                 const scene::Scene& scene,
                                                 const camera::Picture& picture, double time);

/// Adds the inverses of the picture in the previous and the next frame to the settings. The picture
/// has this size in pixels. Cameras of the scene stand where the scene's motion puts them.
[[nodiscard]] Diagnostics add_frames(const RenderOptions& options, const scene::Scene& scene,
                                     const camera::Picture& picture,
                                     const std::pair<std::size_t, std::size_t>& size,
                                     render::Settings& settings);

}  // namespace balcony::cli
