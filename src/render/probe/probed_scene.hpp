// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <utility>

#include "balcony/probe.hpp"
#include "balcony/rays.hpp"
#include "render/job/renderer_state.hpp"
#include "render/tracing/shown_objects.hpp"

namespace balcony::render {

/// The rays of a camera in the picture of a probe, in the axes of its scene. It is an error if the
/// settings are out of range.
[[nodiscard]] Result<rays::RayProgram> compile(const camera::Camera& camera,
                                               const ProbeSettings& settings, Axes axes,
                                               const std::stop_token& stop);

/// The scene of a renderer as it stands at its own time, whatever the interval of the renderer: its
/// hits, and what they tell about its geometry. The renderer must outlive it.
class ProbedScene {
public:
    explicit ProbedScene(const Renderer& renderer, ShownObjects shown = {})
        : traced_(&renderer.state().traced),
          shown_(std::move(shown)),
          scene_(traced_->scene.get()),
          time_(static_cast<float>(traced_->interval.part_at(scene_->time))) {}
    /// With the objects that a probe is of.
    [[nodiscard]] static Result<ProbedScene> make(const Renderer& renderer,
                                                  const ProbeSettings& settings);

    [[nodiscard]] const TracedScene& traced() const { return *traced_; }
    [[nodiscard]] const scene::Scene& scene() const { return *scene_; }

    /// That of rays that meet the scene as it stands.
    [[nodiscard]] float time() const { return time_; }
    [[nodiscard]] embree::Ray ray(const scene::V3f& origin, const scene::V3f& direction) const {
        return {.origin = origin, .direction = direction, .time = time_};
    }
    /// What the rays of the camera are traced in, and whether they meet an instance.
    [[nodiscard]] const embree::Accelerator& shown() const { return shown_.in(*traced_); }
    [[nodiscard]] bool shows(std::size_t instance) const { return shown_.shows(instance); }
    /// In all of the scene or in a part of it, if one is given.
    [[nodiscard]] embree::Hit nearest(const embree::Ray& ray,
                                      const embree::Accelerator* only = nullptr) const {
        return (only != nullptr ? *only : traced_->accelerator).intersect(ray);
    }

    [[nodiscard]] const scene::Instance& instance(const embree::Hit& hit) const {
        return scene_->instances[hit.instance];
    }
    [[nodiscard]] std::uint32_t object(const embree::Hit& hit) const {
        return instance(hit).object;
    }
    [[nodiscard]] const scene::Material& material(const embree::Hit& hit) const {
        return scene_->materials[mesh(hit).material.value()];
    }
    [[nodiscard]] std::array<scene::V3d, 3> corners(const embree::Hit& hit) const {
        std::array<scene::V3d, 3> corners;
        const auto& triangle = mesh(hit).triangles[hit.triangle];
        for (std::size_t i = 0; i < corners.size(); ++i) {
            corners[i] =
                scene::V3d(mesh(hit).positions[triangle[i]]) * instance(hit).world_from_mesh;
        }
        return corners;
    }
    [[nodiscard]] scene::V3f place(const embree::Hit& hit) const {
        const std::array<scene::V3d, 3> p = corners(hit);
        return scene::V3f(p[0] + double{hit.u} * (p[1] - p[0]) + double{hit.v} * (p[2] - p[0]));
    }
    /// Whether a ray meets the back of the triangle.
    [[nodiscard]] bool from_behind(const embree::Hit& hit, const scene::V3f& direction) const {
        const std::array<scene::V3d, 3> p = corners(hit);
        const double facing = (p[1] - p[0]).cross(p[2] - p[0]).dot(scene::V3d(direction));
        return instance(hit).world_from_mesh.determinant() < 0.0 ? facing < 0.0 : facing > 0.0;
    }

private:
    [[nodiscard]] const scene::Mesh& mesh(const embree::Hit& hit) const {
        return scene_->meshes[instance(hit).mesh.value()];
    }

    const TracedScene* traced_;
    ShownObjects shown_;
    const scene::Scene* scene_;
    float time_;
};

}  // namespace balcony::render
