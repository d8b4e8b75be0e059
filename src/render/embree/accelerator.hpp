// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The only layer that uses Embree: a scene is built once and then queried for the nearest hit and
// the transmittance between two points.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>

#include "balcony/base.hpp"
#include "balcony/motion.hpp"
#include "balcony/progress.hpp"
#include "balcony/scene.hpp"
#include "shading/geometry/ray.hpp"

namespace balcony::render::embree {

/// The acceleration structure of a scene. Immutable, for any number of threads.
///
/// Any ray may be traced: one that starts beyond reach(), or that contains values that are not
/// finite, hits nothing and transmits all light.
class Accelerator {
public:
    /// Builds the structure of a consistent scene, as scene::check() says. An instance that Embree
    /// cannot handle (without a finite affine matrix, or with a vertex beyond max_coordinate) is
    /// skipped with a warning that names its object; a lack of memory is an error. What moves is
    /// where it stands at the time of a ray, from 0 to 1 over the interval of the movement. A stop
    /// is an error of Kind::interrupted.
    [[nodiscard]] static Result<Accelerator> build(const scene::Scene& scene,
                                                   const scene::Movement& movement = {},
                                                   const std::stop_token& stop = {},
                                                   const PartDone& progress = {});

    /// The same for the scene of this structure at another time, or edited. Shares the meshes that
    /// are placed in both and keep their shape.
    [[nodiscard]] Result<Accelerator> moved(const scene::Scene& scene,
                                            const scene::Movement& movement,
                                            const std::stop_token& stop = {},
                                            const PartDone& progress = {}) const;

    /// Some of its instances alone, which are not 0 in flags by instance. Shares their meshes.
    [[nodiscard]] Result<Accelerator> only(std::span<const std::uint8_t> shown) const;

    /// The largest absolute coordinate of a ray's origin: max_coordinate, or less if a shared
    /// mesh is placed by a matrix that shrinks it.
    [[nodiscard]] float reach() const;

    [[nodiscard]] Hit intersect(const Ray& ray) const;

    /// The nearest hits of neighbouring packets, whose rays are set where `valid` says that there
    /// is one; pairs of them are traced together. Direction components of nearly 0 change by less
    /// than their rounding error, and rays that cannot be traced become others that hit nothing.
    void intersect(std::span<Packet> packets) const;

    /// The transmittance between a ray's origin and its end; asks for that of surfaces whose
    /// material lets light pass straight on.
    [[nodiscard]] Imath::Color3f transmittance(const Ray& ray,
                                               const TransmittanceSource& surfaces) const;

    /// The same for at most Packet::size rays together: faster if their directions are similar.
    /// Where a ray touches an edge, the others may decide whether it hits.
    void transmittance(std::span<const Ray> rays, const TransmittanceSource& surfaces,
                       std::span<Imath::Color3f> results) const;

private:
    struct State;
    explicit Accelerator(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    [[nodiscard]] static Result<Accelerator> fill(std::shared_ptr<State> state,
                                                  const scene::Scene& scene,
                                                  const scene::Movement& movement,
                                                  const std::stop_token& stop,
                                                  const PartDone& progress);
    std::shared_ptr<const State> state_;
};

}  // namespace balcony::render::embree
