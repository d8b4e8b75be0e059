// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The triangles of a scene that emit light, in world coordinates.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include "balcony/scene.hpp"
#include "shading/geometry/motion_steps.hpp"
#include "shading/geometry/ray.hpp"
#include "shading/lights/light_bounds.hpp"

namespace balcony::render {

using Imath::Color3f;
using Imath::V3f;

/// A triangle in world coordinates.
struct WorldTriangle {
    V3f corner;
    V3f edge_1, edge_2;

    [[nodiscard]] V3f across() const { return edge_1.cross(edge_2); }
    [[nodiscard]] float area() const { return 0.5F * across().length(); }
};

/// Consecutive triangles of an instance.
struct EmissiveRun {
    std::uint32_t instance = 0;
    std::uint32_t first = 0;  ///< Index into Mesh::triangles.
    std::uint32_t count = 0;
};

/// Divides the emissive triangles of a scene into runs: of one triangle each, unless there are so
/// many that the number of runs would exceed a limit. The scene must outlive the object. After a
/// stop, the object is of no use.
class EmissiveTriangles {
public:
    static constexpr std::size_t max_runs = std::size_t{1} << 20U;

    explicit EmissiveTriangles(const scene::Scene& scene, const scene::Movement& movement = {},
                               const std::stop_token& stop = {});

    [[nodiscard]] const std::vector<EmissiveRun>& runs() const { return runs_; }

    [[nodiscard]] std::size_t count() const { return count_; }

    /// The run with a triangle; nothing if the triangle does not emit.
    [[nodiscard]] std::optional<std::size_t> run_with(const embree::Hit& hit) const;

    /// Of the triangles of a run wherever they move. Triangles without an area, or with one that
    /// overflows, have no power.
    [[nodiscard]] LightBounds bounds(const EmissiveRun& run,
                                     const class TextureLibrary* textures) const;

    /// Whether a triangle is a light in a direction to it. All are, from both sides, but for those
    /// of closed objects from inside, where only they themselves could be lit.
    [[nodiscard]] bool shines(std::uint32_t instance, const WorldTriangle& triangle,
                              const V3f& direction) const {
        const float front = placements_[instance].front;
        return front == 0.0F || front * triangle.across().dot(direction) < 0.0F;
    }

    /// Where a triangle that emits is at a time.
    [[nodiscard]] WorldTriangle triangle(std::uint32_t instance, std::uint32_t triangle,
                                         float time) const {
        return at_rest_.empty() ? placed_triangle(instance, triangle, time)
                                : at_rest_[placements_[instance].first_triangle + triangle];
    }

    [[nodiscard]] const scene::Material& material(std::uint32_t instance) const {
        return *placements_[instance].material;
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    struct Placement {
        Imath::M44f world_from_mesh;
        const scene::Material* material = nullptr;
        std::size_t first_run = none;    // None if the instance does not emit.
        std::size_t first_triangle = 0;  // Of those that emit, in the order of runs.
        // 1 if WorldTriangle::across() points out of a closed object, -1 if into it, otherwise 0.
        float front = 0.0F;
    };

    void keep_triangles(const std::stop_token& stop);
    void find_closed_objects(const std::stop_token& stop);
    [[nodiscard]] WorldTriangle placed_triangle(std::uint32_t instance, std::uint32_t triangle,
                                                float time) const;
    [[nodiscard]] float emitted(const EmissiveRun& run, std::uint32_t triangle,
                                const class TextureLibrary* textures) const;

    const scene::Scene* scene_;
    std::size_t count_ = 0;
    std::size_t run_length_ = 1;
    std::vector<Placement> placements_;  // By instance.
    MovingPlacements moving_;
    MovingMeshes shapes_;
    std::vector<EmissiveRun> runs_;
    std::vector<WorldTriangle> at_rest_;  // Empty if something moves, or if they are too many.
};

/// Whether a material emits light.
[[nodiscard]] bool emits(const scene::Material& material);

}  // namespace balcony::render
