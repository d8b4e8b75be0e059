// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Probe: which objects of a scene a camera sees, whether its rays start where they may, and what
// stands between a camera and a point.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
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

/// From where a ray starts to a point that it may show.
struct SightLine {
    Imath::V3d from, to;
};

/// What hides the end of a line from its start.
struct Obstacle {
    std::uint32_t object = 0;  ///< Index into Scene::objects.
    double distance = 0.0;     ///< From the start, in scene units.
};

/// The first opaque surface on each line, none where the point is seen. Lines start and end as the
/// renderer's rays do: a surface at the very start counts, one that the end lies on does not. The
/// end lies on it if it is in the plane of the triangle as far as floats can tell, or if the
/// surface is nearer to it than a hundred-thousandth of the line. `axes` are those of the lines.
[[nodiscard]] Result<std::vector<std::optional<Obstacle>>> find_obstacles(
    const scene::Scene& scene, std::span<const SightLine> lines, Axes axes);

}  // namespace balcony::render
