// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The interface of integrators, which compute the radiance along a ray.

#include <memory>
#include <string_view>

#include "balcony/render.hpp"
#include "render/embree/accelerator.hpp"
#include "render/film/tile_image.hpp"
#include "render/sampling/sampler.hpp"
#include "render/shading/scene_tracer.hpp"

namespace balcony::render {

/// The result of tracing a ray.
struct Seen {
    Color4f radiance{0.0F};  ///< Premultiplied.
    Color4f mirrored{0.0F};  ///< The factors of the background in mirrors, by colour.
    VisibleSurface visible;
};

/// Belongs to one thread. A new integrator needs a file with a class and a maker, and a row in
/// integrators.cpp.
class Integrator {
public:
    virtual ~Integrator() = default;

    /// The radiance of a camera ray, given its first hit. The sampler is that of the ray's pixel
    /// and pass; equal rays with equal samplers give the same result, in any order.
    [[nodiscard]] virtual Seen trace(const Ray& ray, const embree::Hit& first, Sampler sampler) = 0;
};

/// The scene and the settings must outlive the integrator.
using IntegratorMaker = std::unique_ptr<Integrator> (*)(const TracedScene& traced,
                                                        const Settings& settings);

/// The maker of an integrator by its name; null if there is none.
[[nodiscard]] IntegratorMaker find_integrator(std::string_view name);

}  // namespace balcony::render
