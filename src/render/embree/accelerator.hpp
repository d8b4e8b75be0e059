// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The one place that knows Embree: a scene built once, then asked for the nearest hit and for what
// lies between two points.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/scene.hpp"

namespace balcony::render::embree {

using Imath::V3f;

/// A ray in world co-ordinates; distances are in lengths of the direction.
struct Ray {
    V3f origin;
    V3f direction;
    float farthest = std::numeric_limits<float>::infinity();
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

/// How much of the light a surface with transparency stops.
class OpacitySource {
public:
    virtual ~OpacitySource() = default;
    [[nodiscard]] virtual float opacity(const Hit& hit) const = 0;
};

/// The acceleration structure of a scene. Immutable, for any number of threads.
class Accelerator {
public:
    /// Builds; fails where memory runs out.
    [[nodiscard]] static Result<Accelerator> build(const scene::Scene& scene);

    [[nodiscard]] Hit intersect(const Ray& ray) const;

    /// The nearest hits of a grid of neighbouring rays, given row by row; active[i] says whether
    /// ray i is to be traced. Much faster than one after another.
    void intersect_grid(std::size_t width, std::span<const Ray> rays,
                        std::span<const std::uint8_t> active, std::span<Hit> hits) const;

    /// The part of the light that comes through between a ray's origin and its end; surfaces whose
    /// material is not opaque are asked for their opacity.
    [[nodiscard]] float transmittance(const Ray& ray, const OpacitySource& opacities) const;

private:
    struct State;
    explicit Accelerator(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

}  // namespace balcony::render::embree
