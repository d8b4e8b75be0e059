// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What an integrator is: a way to find the light that comes along a ray.

#include <memory>
#include <string_view>

#include "balcony/render.hpp"
#include "render/embree/accelerator.hpp"
#include "render/film/tile_image.hpp"
#include "render/sampling/sampler.hpp"
#include "render/shading/scene_tracer.hpp"

namespace balcony::render {

/// What a ray sees.
struct Seen {
    Color4f radiance{0.0F};  ///< Premultiplied.
    VisibleSurface visible;
};

/// Belongs to one thread. A new one is a file with a class and a maker, and a row in
/// integrators.cpp.
class Integrator {
public:
    virtual ~Integrator() = default;

    /// The radiance of a camera ray, given its first hit. The sampler is that of the ray's pixel
    /// and pass; two rays with equal samplers see the same, in whatever order they are traced.
    [[nodiscard]] virtual Seen trace(const Ray& ray, const embree::Hit& first, Sampler sampler) = 0;
};

/// The scene and the settings outlive what is made.
using IntegratorMaker = std::unique_ptr<Integrator> (*)(const TracedScene& traced,
                                                        const Settings& settings);

/// The maker of an integrator by its name; null if there is none.
[[nodiscard]] IntegratorMaker find_integrator(std::string_view name);

}  // namespace balcony::render
