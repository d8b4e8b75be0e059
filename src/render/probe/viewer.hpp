// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "balcony/scene.hpp"
#include "render/probe/probed_scene.hpp"

namespace balcony::render {

/// The aspect of the views that Viewer::look() judges.
inline constexpr double default_view_aspect = 16.0 / 9.0;

/// What the rays of a coarse picture, or in all directions, meet.
struct Sight {
    std::vector<std::size_t> rays_by_object;
    std::size_t rays = 0;
    std::size_t hits = 0;
    std::size_t fronts = 0;  ///< Hits on the front of a triangle.
    double distance_sum = 0.0;
    double nearest = std::numeric_limits<double>::infinity();

    [[nodiscard]] std::size_t objects() const;
    /// How much it tells: many objects, each large, and far away.
    [[nodiscard]] double interest() const;
};

/// Looks around in a scene.
class Viewer {
public:
    /// The scene must outlive it.
    explicit Viewer(const ProbedScene& scene) : scene_(scene) {}

    [[nodiscard]] Sight look(const scene::Camera& camera) const;
    /// In all directions, on a Fibonacci lattice.
    [[nodiscard]] Sight look_round(const scene::V3d& from) const;
    /// The distance to the first surface along a direction; infinity if there is none.
    [[nodiscard]] double distance(const scene::V3d& from, const scene::V3d& direction) const;
    /// Whether a lamp shines on a point.
    [[nodiscard]] bool is_lit(const scene::V3d& point) const;

private:
    [[nodiscard]] Sight empty_sight() const;
    void add(const scene::V3d& from, const scene::V3d& direction, Sight& sight) const;

    const ProbedScene& scene_;
};

}  // namespace balcony::render
