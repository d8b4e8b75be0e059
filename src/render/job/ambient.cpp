// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/ambient.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "balcony/median.hpp"
#include "images/luminance.hpp"
#include "render/job/coarse_rays.hpp"

namespace balcony::render {

namespace {

// The radiance of a white surface at this place, turned to the lights, and of the place itself.
double brightness(const SceneTracer& tracer, const V3f& to_viewer, const Interaction& at) {
    constexpr float white_radiance = 1.0F / std::numbers::pi_v<float>;
    Color3f total = at.emission(-to_viewer);
    for (std::size_t light = 0; light < tracer.lights().size(); ++light) {
        const Illumination arriving =
            tracer.lights().arriving(light, {at.surface.position, to_viewer});
        if (arriving.to_light.dot(at.surface.normal) > 0.0F) {
            total += white_radiance *
                     tracer.transmittance(at.surface, arriving.to_light, arriving.distance, 0.0F) *
                     arriving.irradiance;
        }
    }
    return static_cast<double>(luminance(total));
}

}  // namespace

Color3f ambient_of(const TracedScene& traced, PictureRays& rays, const Film& film, double time) {
    constexpr double share = 0.1;
    constexpr double in_the_dark = 0.3;
    const SceneTracer tracer(traced);
    std::vector<double> lit;
    for_each_coarse_ray(traced, rays, film, time, [&](const DifferentialRay& ray) {
        if (const embree::Hit hit = tracer.nearest(ray); hit.any()) {
            const double found = brightness(tracer, -ray.direction, tracer.interaction(ray, hit));
            if (found > 0.0 && std::isfinite(found)) {
                lit.push_back(found);
            }
        }
    });
    const std::optional<double> middle = median(std::move(lit));
    return Color3f(static_cast<float>(middle ? share * *middle : in_the_dark));
}

}  // namespace balcony::render
