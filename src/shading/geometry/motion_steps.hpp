// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include "balcony/motion.hpp"

namespace balcony::render {

/// The place of a time from 0 to 1 between equal steps.
struct BetweenSteps {
    std::size_t before = 0;  ///< There is a step after this one, unless there is only one.
    float part = 0.0F;       ///< Of the way to that step.

    /// For a number of steps.
    BetweenSteps(float time, std::size_t count);
};

/// The places of all instances and the vertices of all meshes of a scene at equal steps of time;
/// what stands still has one step. The scene and the movement must outlive it.
class MotionSteps {
public:
    MotionSteps(const scene::Scene& scene, const scene::Movement& movement);

    [[nodiscard]] std::span<const scene::M44d> matrices(std::size_t instance) const {
        const auto found = instances_.find(instance);
        return found == instances_.end()
                   ? std::span(&scene_->instances[instance].world_from_mesh, 1)
                   : std::span<const scene::M44d>(found->second->world_from_mesh);
    }
    /// 1 if the mesh does not change its shape.
    [[nodiscard]] std::size_t shape_count(scene::MeshIndex mesh) const;

    /// The place of an instance and a vertex of a mesh at a time from 0 to 1.
    [[nodiscard]] scene::M44d matrix(std::size_t instance, float time) const;
    [[nodiscard]] Imath::V3f position(scene::MeshIndex mesh, std::size_t vertex, float time) const;

private:
    const scene::Scene* scene_;
    std::unordered_map<std::size_t, const scene::InstanceSteps*> instances_;
    std::unordered_map<std::uint32_t, const std::vector<scene::Shape>*> shapes_;
};

/// The places of the instances that move, in floats, as they are traced: between two steps, the
/// elements of the matrix change linearly.
class MovingPlacements {
public:
    explicit MovingPlacements(const scene::Movement& movement);

    [[nodiscard]] bool empty() const { return steps_.empty(); }
    /// The place of an instance at a time; nothing if it stands still.
    [[nodiscard]] std::optional<Imath::M44f> world_from_mesh(std::uint32_t instance,
                                                             float time) const;
    /// 1 if the instance stands still.
    [[nodiscard]] std::size_t step_count(std::uint32_t instance) const;

private:
    std::unordered_map<std::uint32_t, std::vector<Imath::M44f>> steps_;
};

/// The corners of a triangle of a mesh.
struct MeshCorners {
    std::array<Imath::V3f, 3> positions;
    std::array<Imath::V3f, 3> normals;
};

/// The meshes that change their shapes, as they are traced: between two steps, vertices move along
/// straight lines.
class MovingMeshes {
public:
    explicit MovingMeshes(const scene::Movement& movement);

    [[nodiscard]] bool empty() const { return shapes_.empty(); }
    /// A triangle at a time; nothing if the mesh does not change its shape.
    [[nodiscard]] std::optional<MeshCorners> corners(scene::MeshIndex mesh,
                                                     const std::array<std::uint32_t, 3>& triangle,
                                                     float time) const;
    /// 1 if the mesh does not change its shape.
    [[nodiscard]] std::size_t step_count(scene::MeshIndex mesh) const;

private:
    std::unordered_map<std::uint32_t, std::shared_ptr<const std::vector<scene::Shape>>> shapes_;
};

}  // namespace balcony::render
