// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The only layer that uses Embree: a scene is built once and then queried for the nearest hit and
// the transmittance between two points.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/motion.hpp"
#include "balcony/scene.hpp"

namespace balcony::render::embree {

using Imath::V3f;

/// The largest absolute value of a coordinate that Embree accepts in vertices and rays: its
/// FLT_LARGE.
inline constexpr float max_coordinate = 1.844e18F;

/// Whether all coordinates are finite and within that limit.
template <class Vector>
[[nodiscard]] bool in_range(const Vector& v) {
    constexpr typename Vector::BaseType limit = max_coordinate;
    return std::abs(v.x) <= limit && std::abs(v.y) <= limit && std::abs(v.z) <= limit;
}

/// A ray in world coordinates; distances are in lengths of the direction.
struct Ray {
    V3f origin;
    V3f direction;
    float farthest = std::numeric_limits<float>::infinity();
    float time = 0.0F;  ///< From 0 to 1 over the shutter interval.
};

/// A point of a triangle: (1 - u - v) p0 + u p1 + v p2.
struct Hit {
    static constexpr std::uint32_t nothing = 0xffffffffU;

    std::uint32_t instance = nothing;  ///< Index into Scene::instances.
    std::uint32_t triangle = 0;        ///< Index into Mesh::triangles.
    float u = 0.0F;
    float v = 0.0F;

    [[nodiscard]] bool any() const { return instance != nothing; }
};

/// The rays of a square of neighbouring points, row by row, and their nearest hits. The arrays
/// before `valid` have the layout of Embree's own packets, so that tracing copies nothing.
struct alignas(64) Packet {
    static constexpr std::size_t side = 4;
    static constexpr std::size_t size = side * side;
    using Floats = std::array<float, size>;
    using Numbers = std::array<std::uint32_t, size>;

    Floats origin_x{}, origin_y{}, origin_z{};
    Floats nearest{};
    Floats direction_x{}, direction_y{}, direction_z{};
    Floats time{};
    Floats farthest{};  ///< Tracing sets it to the distance of a hit.
    Numbers mask{};
    Numbers id{};
    Numbers flags{};
    Floats normal_x{}, normal_y{}, normal_z{};  ///< Of the triangle, of any length and on any side;
                                                ///< in the mesh's coordinates if it is placed.
    Floats u{}, v{};
    Numbers triangle{};
    Numbers geometry{};
    Numbers placement{};

    alignas(64) std::array<std::int32_t, size> valid{};  ///< -1 where there is a ray, otherwise 0.

    void set(std::size_t lane, const Ray& ray);

    [[nodiscard]] V3f origin(std::size_t lane) const {
        return {origin_x[lane], origin_y[lane], origin_z[lane]};
    }
    [[nodiscard]] V3f direction(std::size_t lane) const {
        return {direction_x[lane], direction_y[lane], direction_z[lane]};
    }
    [[nodiscard]] V3f normal(std::size_t lane) const {
        return {normal_x[lane], normal_y[lane], normal_z[lane]};
    }
    /// Whether the mesh is placed by a matrix for tracing, rather than copied into the world.
    [[nodiscard]] bool is_placed(std::size_t lane) const { return placement[lane] != Hit::nothing; }
    [[nodiscard]] bool any(std::size_t lane) const { return geometry[lane] != Hit::nothing; }
    [[nodiscard]] std::uint32_t instance(std::size_t lane) const {
        return is_placed(lane) ? placement[lane] : geometry[lane];
    }
    [[nodiscard]] Hit hit(std::size_t lane) const {
        return any(lane) ? Hit{instance(lane), triangle[lane], u[lane], v[lane]} : Hit{};
    }
};

/// The fraction of the light that a transparent surface blocks.
class OpacitySource {
public:
    virtual ~OpacitySource() = default;
    [[nodiscard]] virtual float opacity(const Hit& hit) const = 0;
};

/// The acceleration structure of a scene. Immutable, for any number of threads.
///
/// Any ray may be traced: one that starts beyond reach(), or that contains values that are not
/// finite, hits nothing and transmits all light.
class Accelerator {
public:
    /// Rays of a grid are traced together in packets, and pairs of neighbouring packets of a row,
    /// from the first on.
    static constexpr std::size_t packet_side = Packet::side;
    static constexpr std::size_t packet_size = Packet::size;
    static constexpr std::size_t pair_width = 2 * packet_side;

    /// Builds the structure. An instance that Embree cannot handle (without a finite affine matrix,
    /// or with a vertex beyond max_coordinate) is skipped with a warning that names its object; a
    /// scene with invalid indices and a lack of memory are errors. What moves is where it stands at
    /// the time of a ray, from 0 to 1 over the interval of the movement.
    [[nodiscard]] static Result<Accelerator> build(const scene::Scene& scene,
                                                   const scene::Movement& movement = {});

    /// The same for the scene of this structure at another time. Shares the meshes that are placed
    /// and keep their shape.
    [[nodiscard]] Result<Accelerator> moved(const scene::Scene& scene,
                                            const scene::Movement& movement) const;

    /// The largest absolute coordinate of a ray's origin: max_coordinate, or less if a shared
    /// mesh is placed by a matrix that shrinks it.
    [[nodiscard]] float reach() const;

    [[nodiscard]] Hit intersect(const Ray& ray) const;

    /// The nearest hits of neighbouring packets, whose rays are set where `valid` says that there
    /// is one; pairs of them are traced together. Direction components of nearly 0 change by less
    /// than their rounding error, and rays that cannot be traced become others that hit nothing.
    void intersect(std::span<Packet> packets) const;

    /// The nearest hits of a grid of neighbouring rays, given row by row; active[i] says whether
    /// ray i is to be traced. Much faster than one after another.
    void intersect_grid(std::size_t width, std::span<const Ray> rays,
                        std::span<const std::uint8_t> active, std::span<Hit> hits) const;

    /// The transmittance between a ray's origin and its end; looks up the opacity of surfaces whose
    /// material is not opaque.
    [[nodiscard]] float transmittance(const Ray& ray, const OpacitySource& opacities) const;

    /// The same for at most packet_size rays together: faster if their directions are similar.
    /// Where a ray touches an edge, the others may decide whether it hits.
    void transmittance(std::span<const Ray> rays, const OpacitySource& opacities,
                       std::span<float> results) const;

private:
    struct State;
    explicit Accelerator(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    [[nodiscard]] static Result<Accelerator> fill(std::shared_ptr<State> state,
                                                  const scene::Scene& scene,
                                                  const scene::Movement& movement);
    std::shared_ptr<const State> state_;
};

}  // namespace balcony::render::embree
