// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "balcony/film.hpp"
#include "balcony/render.hpp"
#include "render/integrators/integrator.hpp"
#include "render/job/picture_rays.hpp"
#include "render/tracing/scene_tracer.hpp"

namespace balcony::render {

/// How bright the indirect light of single samples commonly is, from place to place in a picture:
/// by a first look at coarse rays of the whole of it, so whatever the film's window, the seed and
/// the number of samples.
class LightLevels {
public:
    /// No limits.
    LightLevels() = default;
    /// After a stop, it is of no use.
    LightLevels(const TracedScene& traced, const Settings& settings,
                const IntegratorRow& integrator, PictureRays& rays, const Film& film,
                const std::stop_token& stop);

    /// CameraRay::limit in a pixel of a camera layer. It grows with the passes, so that the light
    /// that it leaves out goes to nothing.
    [[nodiscard]] float limit(std::size_t layer, std::size_t x, std::size_t y,
                              std::size_t pass) const;

private:
    rays::Tile grid_{};
    std::vector<std::vector<float>> levels_;  // By camera layer, at the points of the grid.
};

}  // namespace balcony::render
