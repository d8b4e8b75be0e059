// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/lighting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "balcony/median.hpp"
#include "balcony/names.hpp"
#include "images/luminance.hpp"
#include "render/job/coarse_rays.hpp"
#include "render/sampling/even_pairs.hpp"
#include "shading/geometry/frame.hpp"

namespace balcony::render {

namespace {

// Whether rays leave the scene: rays of the picture, or rays that surfaces scatter evenly.
bool sees_sky(const TracedScene& traced, PictureRays& all, const Film& film, double time) {
    constexpr double least = 0.02;  // The share of such rays in a room with a window.
    const SceneTracer tracer(traced);
    std::size_t rays = 0;
    std::size_t escaped = 0;
    for_each_coarse_ray(traced, all, film, time, [&](const DifferentialRay& ray) {
        const embree::Hit hit = tracer.nearest(ray);
        ++rays;
        if (!hit.any()) {
            ++escaped;
            return;
        }
        const Imath::V2f numbers = even_pair(rays);
        const Surface surface = traced.surfaces.find(hit, ray.direction, ray.time);
        const V3f direction =
            Frame(surface.geometric_normal).to_world(sample_cosine(numbers.x, numbers.y));
        escaped +=
            is_black(tracer.transmittance({surface.start(direction), direction,
                                           std::numeric_limits<float>::infinity(), ray.time}))
                ? 0
                : 1;
    });
    return static_cast<double>(escaped) >= least * static_cast<double>(rays);
}

std::string description_of(const LightSet& lights, const scene::Scene& scene) {
    std::string text;
    const auto add = [&text](std::size_t count, std::string_view noun) {
        if (count > 0) {
            text += (text.empty() ? "" : ", ") + counted(count, noun);
        }
    };
    add(scene.lights.size(), "lamp");
    add(lights.emissive_triangles(), "emitting triangle");
    return text;
}

// The light of suns on surfaces that face them, in lux; 0 if anything else lights the scene.
float light_of_suns(const LightSet& lights, const scene::Scene& scene) {
    float sum = 0.0F;
    for (const scene::Light& light : scene.lights) {
        if (light.kind != scene::LightKind::directional) {
            return 0.0F;
        }
        sum += luminance(light.intensity);
    }
    return lights.emissive_triangles() > 0 ? 0.0F : sum;
}

// The scene's own lights, and a soft sky beside suns: it enters by the windows that they enter by.
Lighting lit_by_itself(const TracedScene& traced, std::string own, const Settings& settings) {
    const float suns = light_of_suns(traced.lights, *traced.scene);
    if (!settings.light.sky_beside_suns || !(suns > 0.0F)) {
        return {traced.lights.with({}, settings.light.sun_angle), std::move(own)};
    }
    if (settings.light.substitute.value_or(SubstituteLight::sky) != SubstituteLight::sky) {
        return {traced.lights.with({}, settings.light.sun_angle), std::move(own),
                SubstituteLight::none};
    }
    // Of the dome, a white floor has radiance 1, and so an illuminance of pi.
    constexpr float of_suns = 0.2F / std::numbers::pi_v<float>;
    return {
        traced.lights.with(Environment::dome().scaled(of_suns * suns), settings.light.sun_angle),
        own + " and a soft sky, as the scene has a sun and no sky", SubstituteLight::sky};
}

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

Lighting lighting_of(const TracedScene& traced, PictureRays& rays, const Film& film,
                     const Settings& settings) {
    std::string own = description_of(traced.lights, *traced.scene);
    if (settings.light.substitute == SubstituteLight::eye && !own.empty()) {
        return {traced.lights.lit_from_eye(), "a light at the eye alone", SubstituteLight::eye};
    }
    std::optional<Environment> environment = settings.light.environment;
    if (!environment && settings.ambient) {
        environment = Environment::constant(*settings.ambient);
    }
    if (environment) {
        return {traced.lights.with(environment, settings.light.sun_angle),
                fmt::format("{}{}{}", own, own.empty() ? "" : ", ", environment->description())};
    }
    if (!own.empty() || !traced.scene->default_light) {
        return lit_by_itself(traced, own.empty() ? "no light" : std::move(own), settings);
    }
    const SubstituteLight substitute = settings.light.substitute ? *settings.light.substitute
                                       : sees_sky(traced, rays, film, settings.time)
                                           ? SubstituteLight::sky
                                           : SubstituteLight::eye;
    if (substitute == SubstituteLight::sky) {
        const Environment sky = Environment::dome();
        return {traced.lights.with(sky), sky.description(), substitute};
    }
    return {traced.lights.lit_from_eye(), "a light at the eye, as the scene has none", substitute};
}

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
