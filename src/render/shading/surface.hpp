// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The surface at the hit of a ray, and the ray's footprint on it.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include "balcony/scene.hpp"
#include "render/embree/accelerator.hpp"
#include "render/textures/texture_library.hpp"

namespace balcony::render {

using Imath::V2f;
using Imath::V3f;

/// The change of a ray from a pixel to its right (x) and lower (y) neighbour: the ray differentials
/// of Igehy, "Tracing Ray Differentials" (1999).
struct RayDifferentials {
    V3f origin_x{0.0F}, origin_y{0.0F};
    V3f direction_x{0.0F}, direction_y{0.0F};
};

/// A ray with unit direction.
struct Ray {
    V3f origin;
    V3f direction;
    RayDifferentials differentials{};
    float time = 0.0F;  ///< From 0 to 1 over the shutter interval.
};

/// The change of a surface point from a pixel to the next.
struct PositionDifferentials {
    V3f along_x{0.0F}, along_y{0.0F};
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
    bool entering = true;  ///< Whether the ray comes from outside, according to the winding.
    V3f edge_1, edge_2;    ///< Of the triangle, from its first vertex.
    V2f texture_point;
    V2f texture_edge_1, texture_edge_2;
    scene::Color3f color{1.0F, 1.0F, 1.0F};  ///< Of the mesh, a factor of the base colour.
    float offset = 0.0F;  ///< A distance from the surface larger than any rounding error.
    V3f rounding_out;     ///< From the position to the smooth surface that the normals describe.
    const scene::Material* material = nullptr;
    std::uint32_t object = 0;

    /// The origin of a ray that leaves in a direction, offset to avoid hitting this surface again.
    [[nodiscard]] V3f start(const V3f& direction) const;
    /// The origin of a ray to a light: on the smooth surface that the normals describe, on the side
    /// that the ray came from, so that the facets of a coarse mesh do not shadow each other.
    [[nodiscard]] V3f start_to_light() const;
    /// The intersections of the neighbouring pixels' rays with the plane of the triangle, as
    /// differences.
    [[nodiscard]] PositionDifferentials transfer(const Ray& ray) const;
    [[nodiscard]] TextureFootprint texture_footprint(const PositionDifferentials& position) const;
};

/// Computes surfaces from hits.
class SurfaceFinder {
public:
    explicit SurfaceFinder(const scene::Scene& scene);

    [[nodiscard]] Surface find(const embree::Hit& hit, const V3f& direction) const;
    /// Only the texture coordinates of a hit.
    [[nodiscard]] V2f texture_point(const embree::Hit& hit) const;
    [[nodiscard]] const scene::Material& material(const embree::Hit& hit) const;

private:
    struct Placement {
        Imath::M44f world_from_mesh;
        Imath::M33f normal_from_mesh;
        bool mirrors = false;  // The winding is reversed.
    };

    [[nodiscard]] const scene::Mesh& mesh(const embree::Hit& hit) const;

    const scene::Scene* scene_;
    std::vector<Placement> placements_;  // By instance.
};

}  // namespace balcony::render
