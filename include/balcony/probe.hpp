// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Probe: which objects of a scene a camera sees, and whether its rays start where they may.

#include <cstddef>
#include <optional>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/camera.hpp"
#include "balcony/scene.hpp"

namespace balcony::render {

struct ProbeSettings {
    std::size_t width = 1280;  ///< Of the picture, in pixels.
    std::size_t height = 720;
    std::size_t step = 4;  ///< Pixels from ray to ray; what is not seen then is looked for in all.
    double time = 0.0;     ///< The t of the camera's formulas.
};

/// What a camera has to do with an object of the scene.
struct ObjectSight {
    bool has_surface = false;
    bool seen = false;
    /// Of the rays at the step, how many start inside. Only an object whose surface is closed and
    /// faces outwards has an inside.
    std::size_t rays_from_inside = 0;
    Imath::V2d inside_at{0.0};  ///< A picture point, in pixels, whose ray does.
};

struct Probe {
    std::size_t rays = 0;                     ///< Those at the step.
    std::vector<ObjectSight> objects;         ///< As Scene::objects.
    std::optional<double> median_distance{};  ///< From origin to first hit, in scene units.
};

/// Surfaces with transparency are seen, and what is behind them, too.
[[nodiscard]] Result<Probe> probe(const scene::Scene& scene, const camera::Camera& camera,
                                  const ProbeSettings& settings);

}  // namespace balcony::render
