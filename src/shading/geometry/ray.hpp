// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rays and their hits, as Embree takes and gives them.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include "shading/lanes/lane_arrays.hpp"

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
    static_assert(size == lane_count);
    using Floats = LaneFloats;
    using Numbers = LaneNumbers;

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
    Numbers placement_part{};  ///< Of an array of placements, of which there are none.

    alignas(64) std::array<std::int32_t, size> valid{};  ///< -1 where there is a ray, otherwise 0.

    void set(std::size_t lane, const Ray& ray) {
        origin_x[lane] = ray.origin.x;
        origin_y[lane] = ray.origin.y;
        origin_z[lane] = ray.origin.z;
        direction_x[lane] = ray.direction.x;
        direction_y[lane] = ray.direction.y;
        direction_z[lane] = ray.direction.z;
        time[lane] = ray.time;
        farthest[lane] = ray.farthest;
        valid[lane] = -1;
    }

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
    /// Takes the hit of a ray that continues this one.
    void take_hit(const Packet& further, std::size_t lane) {
        for (const auto floats : {&Packet::farthest, &Packet::normal_x, &Packet::normal_y,
                                  &Packet::normal_z, &Packet::u, &Packet::v}) {
            (this->*floats)[lane] = (further.*floats)[lane];
        }
        for (const auto numbers : {&Packet::triangle, &Packet::geometry, &Packet::placement}) {
            (this->*numbers)[lane] = (further.*numbers)[lane];
        }
    }
    [[nodiscard]] Hit hit(std::size_t lane) const {
        return any(lane) ? Hit{instance(lane), triangle[lane], u[lane], v[lane]} : Hit{};
    }
};

/// The fraction of the light that passes a surface in the direction of a ray, which it keeps.
class TransmittanceSource {
public:
    virtual ~TransmittanceSource() = default;
    [[nodiscard]] virtual Imath::Color3f transmittance(const Hit& hit, const Ray& ray) const = 0;
};

}  // namespace balcony::render::embree
