// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The surface at the hit of a ray, and the ray's footprint on it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include "balcony/motion.hpp"
#include "balcony/scene.hpp"
#include "shading/geometry/motion_steps.hpp"
#include "shading/geometry/ray.hpp"
#include "shading/textures/texture_library.hpp"

namespace balcony::render {

using Imath::V2f;
using Imath::V3f;
using Imath::V4f;

/// The change of a ray from a pixel to its right (x) and lower (y) neighbour: the ray differentials
/// of Igehy, "Tracing Ray Differentials" (1999).
struct RayDifferentials {
    V3f origin_x{0.0F}, origin_y{0.0F};
    V3f direction_x{0.0F}, direction_y{0.0F};
};

/// A ray with unit direction.
struct DifferentialRay {
    V3f origin;
    V3f direction;
    RayDifferentials differentials{};
    float time = 0.0F;  ///< From 0 to 1 over the shutter interval.
};

/// The change of a surface point from a pixel to the next.
struct PositionDifferentials {
    V3f along_x{0.0F}, along_y{0.0F};
};

/// A footprint in barycentric coordinates: the shares of the second and third vertex.
struct TriangleFootprint {
    V2f along_x{0.0F}, along_y{0.0F};
};

/// A point of a triangle of a mesh.
struct MeshPoint {
    const scene::Mesh* mesh = nullptr;
    std::uint32_t triangle = 0;
    float u = 0.0F, v = 0.0F;  ///< The shares of its second and third vertex.

    /// A footprint that covers more repetitions of an image is reduced to so many, for numerical
    /// safety, without visible effect.
    static constexpr float widest_footprint = 64.0F;

    /// The vectors in the image, from the first vertex to the others; 0 without coordinates.
    [[nodiscard]] std::array<V2f, 2> texture_edges(const scene::TextureUse& use) const;
    /// The footprint in the image of a use of a texture; a point if the triangle's is one.
    [[nodiscard]] TextureFootprint texture_footprint(const scene::TextureUse& use,
                                                     const TriangleFootprint& footprint = {}) const;
    /// The vertices' colour, or white.
    [[nodiscard]] scene::Color4f color() const;
};

/// The maximum number of transparent surfaces that a ray passes; the next one is treated as opaque.
inline constexpr std::size_t max_crossings = 64;

/// A ray to a point ends slightly before it, by more than the rounding error of its length.
inline constexpr float nearly_all = 1.0F - 1e-5F;

struct Surface {
    V3f position;
    V3f geometric_normal;  ///< Unit, towards the side the ray comes from.
    V3f smooth_normal;     ///< Unit, interpolated from the corners, on the same side and seen from
                           ///< the ray.
    V3f normal;            ///< The same, bent by the normal map: for shading.
    V3f coat_normal;       ///< The same, bent by the clearcoat's normal map.
    V3f mesh_normal;       ///< Unit, interpolated from the corners, as the mesh has it.
    V3f edge_1, edge_2;    ///< Of the triangle, from its first vertex.
    V4f tangent{0.0F};     ///< Of the mesh, in the world; 0 if it has none.
    bool entering = true;  ///< The ray comes from the side that the winding of the mesh faces.
    float offset = 0.0F;   ///< A distance from the surface larger than any rounding error.
    V3f rounding_out;      ///< From the position to the smooth surface that the normals describe.
    MeshPoint in_mesh;
    const scene::Material* material = nullptr;
    std::uint32_t object = 0;
    std::uint32_t instance = 0;

    /// The origin of a ray that leaves in a direction, offset to avoid hitting this surface again.
    [[nodiscard]] V3f start(const V3f& direction) const;
    /// The origin of a ray to a light: on the smooth surface that the normals describe, on the side
    /// that the ray came from, so that the facets of a coarse mesh do not shadow each other.
    [[nodiscard]] V3f start_to_light() const;
    /// The intersections of the neighbouring pixels' rays with the plane of the triangle, as
    /// differences.
    [[nodiscard]] PositionDifferentials transfer(const DifferentialRay& ray) const;
    /// The footprint on the triangle.
    [[nodiscard]] TriangleFootprint triangle_footprint(const PositionDifferentials& moved) const;
    /// The smooth normal, bent to a normal in the tangent space of a use of a texture, whose z is
    /// the mesh's normal: (0, 0, 1) changes nothing. `to_viewer` is the reversed ray.
    [[nodiscard]] V3f mapped_normal(const V3f& in_tangent_space, const scene::TextureUse& use,
                                    const V3f& to_viewer) const;
};

/// A mesh that is placed in the world and does not move.
struct PlacedMesh {
    const scene::Mesh* mesh = nullptr;
    Imath::M44f world_from_mesh;
    Imath::M33f normal_from_mesh;  ///< For normals: the inverse, transposed.
};

/// Computes surfaces from hits.
class SurfaceFinder {
public:
    explicit SurfaceFinder(const scene::Scene& scene, const scene::Movement& movement = {});

    /// The surface at the hit of a ray with a direction and a time.
    [[nodiscard]] Surface find(const embree::Hit& hit, const V3f& direction,
                               float time = 0.0F) const;
    /// The mesh of an instance; nothing if it moves or changes its shape.
    [[nodiscard]] std::optional<PlacedMesh> mesh_at_rest(std::uint32_t instance) const;
    /// Requests the memory that find() reads, for a hit of soon, in two steps: its triangle, and
    /// its corners. Most of the time of find() is spent waiting for it otherwise.
    void request_triangle(const embree::Hit& hit) const;
    void request_corners(const embree::Hit& hit) const;
    /// Only where a hit is in its mesh.
    [[nodiscard]] MeshPoint mesh_point(const embree::Hit& hit) const {
        return {placements_[hit.instance].mesh, hit.triangle, hit.u, hit.v};
    }

private:
    struct Placement {
        Imath::M44f world_from_mesh;
        Imath::M33f normal_from_mesh;
        const scene::Mesh* mesh = nullptr;
        float side = 1.0F;  // -1 if the placement mirrors, which reverses the winding.
    };

    [[nodiscard]] static V4f placed_tangent(const MeshPoint& point, const Placement& placement);
    [[nodiscard]] Placement placement_at(std::uint32_t instance, float time) const;

    const scene::Scene* scene_;
    std::vector<Placement> placements_;  // By instance.
    MovingPlacements moving_;
    MovingMeshes shapes_;
};

}  // namespace balcony::render
