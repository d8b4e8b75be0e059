// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/integrators/shown_surface.hpp"

#include <optional>

#include "images/luminance.hpp"

namespace balcony::render {

namespace {

using Sample = std::optional<BsdfSample>;

struct Ways {
    Sample mirrored;
    Sample passed;
};

// None if the surface shows itself.
Ways ways_of(const DifferentialRay& ray, const Interaction& at) {
    const Bsdf bsdf = at.bsdf();
    if (at.appearance().unlit || !is_black(bsdf.material().diffuse)) {
        return {};
    }
    return {bsdf.sample_mirror(-ray.direction), bsdf.sample_passage(-ray.direction)};
}

float part_of(const Sample& way) { return way ? luminance(way->weight) : 0.0F; }

DifferentialRay next_ray(const DifferentialRay& ray, const Interaction& at, const Sample& way) {
    return {at.surface.start(way->to_light), way->to_light, {}, ray.time};
}

VisibleSurface shown_along(const SceneTracer& tracer, DifferentialRay ray, Color3f part) {
    constexpr std::size_t most_passed = 16;
    for (std::size_t passed = 0; passed < most_passed; ++passed) {
        const embree::Hit hit = tracer.nearest(ray);
        if (!hit.any()) {
            return {};
        }
        const Interaction at = tracer.interaction(ray, hit);
        if (at.appearance().opacity < 0.5F) {
            ray.origin = at.surface.start(ray.direction);
            continue;
        }
        const Ways ways = ways_of(ray, at);
        const Sample& way =
            part_of(ways.passed) >= part_of(ways.mirrored) ? ways.passed : ways.mirrored;
        if (!way) {
            VisibleSurface shown = tracer.visible(at);
            shown.albedo *= part;
            return shown;
        }
        part *= way->weight;
        ray = next_ray(ray, at, way);
    }
    return {};
}

}  // namespace

VisibleSurface shown_by_glass(const SceneTracer& tracer, const DifferentialRay& ray,
                              const Interaction& at) {
    const Ways ways = ways_of(ray, at);
    VisibleSurface shown;
    for (const Sample& way : {ways.mirrored, ways.passed}) {
        if (way) {
            const VisibleSurface one = shown_along(tracer, next_ray(ray, at, way), way->weight);
            const float part = part_of(way);
            shown.any |= one.any;
            shown.position += part * one.position;
            shown.normal += part * one.normal;
            shown.albedo += one.albedo;
        }
    }
    return shown;
}

}  // namespace balcony::render
