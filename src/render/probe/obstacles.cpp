// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "balcony/probe.hpp"
#include "balcony/render.hpp"
#include "render/job/camera_rays.hpp"
#include "render/probe/probed_scene.hpp"
#include "render/tracing/shown_objects.hpp"

namespace balcony::render {

namespace {

using Imath::V3d;

/// Traces lines, one after another; belongs to one thread.
class SightTracer {
public:
    explicit SightTracer(const ProbedScene& scene) : scene_(scene) {}

    [[nodiscard]] std::optional<Obstacle> operator()(const V3d& from, const V3d& to,
                                                     const embree::Accelerator* only) const {
        const V3d way = to - from;
        const double size = std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)});
        const V3d scaled = way / size;  // Avoids overflow of squares.
        // Rejects lines without length, with NaN, or too long for the renderer.
        if (!(scaled.length() > 0.0) || !embree::in_range(from)) {
            return std::nullopt;
        }
        const V3d direction = scaled.normalized();
        const double length = size * scaled.length();
        embree::Ray ray = scene_.ray(V3f(from), V3f(direction));
        for (std::size_t crossings = 0;; ++crossings) {
            const embree::Hit hit = scene_.nearest(ray, only);
            if (!hit.any()) {
                return std::nullopt;
            }
            const Surface surface = scene_.traced().surfaces.find(hit, ray.direction, ray.time);
            const double distance = (V3d(surface.position) - from).dot(direction);
            if (distance >= nearly_all * length) {
                return std::nullopt;
            }
            if (crossings == max_crossings || (!holds(surface, to) && is_opaque(surface))) {
                return Obstacle{surface.object, std::max(distance, 0.0)};
            }
            ray.origin = surface.start(ray.direction);
        }
    }

private:
    // Whether a point lies in the plane of the triangle. If the line is nearly parallel to the
    // plane, the hit may be far from its end, but rounding does not move it off the plane.
    static bool holds(const Surface& surface, const V3d& point) {
        const double height = (point - V3d(surface.position)).dot(V3d(surface.geometric_normal));
        return std::abs(height) <= surface.offset;
    }

    [[nodiscard]] bool is_opaque(const Surface& surface) const {
        return scene_.traced().materials.opacity(surface.in_mesh) >= 1.0F;
    }

    const ProbedScene& scene_;
};

}  // namespace

Result<std::vector<std::optional<Obstacle>>> find_obstacles(const Renderer& renderer,
                                                            std::span<const SightLine> lines,
                                                            Axes axes,
                                                            const std::stop_token& stop) {
    const ProbedScene scene(renderer);
    const SightTracer look(scene);
    std::vector<std::optional<Obstacle>> found;
    found.reserve(lines.size());
    std::map<const camera::ObjectFilter*, ShownObjects> filters;
    filters[nullptr];  // All.
    for (const SightLine& line : lines) {
        if (stop.stop_requested()) {
            return stopped();
        }
        auto shown = filters.find(line.objects);
        if (shown == filters.end()) {
            Result<ShownObjects> some = shown_by(*line.objects, scene.traced());
            if (!some) {
                return std::move(some.diagnostics);
            }
            shown = filters.emplace(line.objects, std::move(*some)).first;
        }
        found.push_back(look(turned(line.from, axes, scene.scene().axes),
                             turned(line.to, axes, scene.scene().axes), shown->second.only()));
    }
    return {std::move(found), scene.traced().textures->warnings()};
}

}  // namespace balcony::render
