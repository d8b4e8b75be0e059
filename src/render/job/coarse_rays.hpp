// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stop_token>

#include "balcony/film.hpp"
#include "render/job/picture_rays.hpp"
#include "render/tracing/scene_tracer.hpp"

namespace balcony::render {

/// About so many points that are evenly distributed over a picture of this size in pixels.
[[nodiscard]] rays::Tile coarse_grid(std::size_t width, std::size_t height, double points,
                                     double time);

/// About 2048 points of the whole picture, whatever the film's window.
[[nodiscard]] rays::Tile coarse_grid(const Film& film, double time);

/// The ray of a point of such a grid, which can be traced. It has a footprint if the scene has
/// textures. Of a bent ray it is the straight part that meets the scene first, or else the last.
[[nodiscard]] DifferentialRay coarse_ray(const TracedScene& traced, const rays::Tile& grid,
                                         const TileRays& rays, std::size_t i);

/// Visits these rays of each camera layer.
void for_each_coarse_ray(const TracedScene& traced, PictureRays& rays, const Film& film,
                         double time, const std::function<void(const DifferentialRay&)>& visit);

/// Decodes the textures that do not fit into memory and that coarse rays of the picture see, on all
/// threads. Otherwise, the first ray that meets one decodes it, while others wait.
void read_visible_textures(const TracedScene& traced, PictureRays& rays, const Film& film,
                           double time, const std::stop_token& stop);

}  // namespace balcony::render
