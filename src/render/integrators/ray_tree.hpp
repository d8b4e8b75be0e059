// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The common part of deterministic integrators.

#include <array>
#include <optional>
#include <vector>

#include "render/integrators/integrator.hpp"

namespace balcony::render {

/// Traces a ray through transparent surfaces and along reflections: Whitted's ray tree
/// ("An Improved Illumination Model for Shaded Display", 1980). The derived class defines the
/// radiance of a surface, its reflection and what passes through it.
class RayTree : public Integrator {
public:
    explicit RayTree(const TracedScene& traced) : tracer_(traced) {}

    void trace(std::span<const CameraRay> rays, const ShownObjects& shown,
               std::span<Seen> seen) final;

protected:
    /// A pending ray, and the fraction of its radiance that reaches the camera.
    struct Branch {
        DifferentialRay ray;
        Color3f weight{1.0F};
        std::size_t reflections = 0;  ///< And passages through glass.
        std::size_t crossings = 0;
    };

    /// The radiance of a surface towards the ray's origin.
    struct Shaded {
        Color3f emission;
        Color3f ambient;  ///< Reflected light that many surfaces have scattered before.
        Color3f direct;   ///< Reflected light of lamps.
    };

    /// A reflected branch, and one that passes through glass, each if there is one.
    using Branches = std::array<std::optional<Branch>, 2>;

    /// Without the branches of scatter().
    [[nodiscard]] virtual Shaded shade(const DifferentialRay& ray, const Interaction& at) const = 0;
    /// `weight` is the part of the light from this surface that reaches the camera.
    [[nodiscard]] virtual Branches scatter(const Branch& arriving, const Color3f& weight,
                                           const Interaction& at) const;

    [[nodiscard]] Seen trace(const DifferentialRay& ray, const embree::Hit& first,
                             const ShownObjects& shown);
    [[nodiscard]] const SceneTracer& tracer() const { return tracer_; }

private:
    void follow(const Branch& branch, const embree::Hit& hit, Seen& seen);

    SceneTracer tracer_;
    std::vector<Branch> open_;  // Empty between two camera rays; kept to reuse its memory.
};

}  // namespace balcony::render
