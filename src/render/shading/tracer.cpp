// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/shading/tracer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/shading/lights.hpp"

namespace balcony::render {

namespace {

// Rays that one camera ray may lead to, and the weight below which none is followed: less than half
// a step of an 8-bit picture.
constexpr std::size_t max_rays = 256;
constexpr float min_weight = 1.0F / 512.0F;

float largest(const Color3f& color) { return std::max({color.x, color.y, color.z}); }

V3f mirrored(const V3f& v, const V3f& normal) { return v - 2.0F * v.dot(normal) * normal; }

embree::Ray to_embree(const Ray& ray) { return {ray.origin, ray.direction}; }

}  // namespace

Tracer::Tracer(const TracedScene& traced, const Settings& settings)
    : traced_(&traced), settings_(&settings), cache_(traced.textures->thread_cache()) {}

Tracer::Result Tracer::trace(const Ray& ray, const embree::Hit& first) {
    Result result{Color4f(0.0F), {}};
    pending_.clear();
    follow({ray, Color3f(1.0F)}, first, result);
    for (std::size_t followed = 0; !pending_.empty() && followed < max_rays; ++followed) {
        const Pending next = pending_.back();
        pending_.pop_back();
        follow(next, traced_->accelerator.intersect(to_embree(next.ray)), result);
    }
    return result;
}

void Tracer::follow(const Pending& pending, const embree::Hit& hit, Result& result) {
    const auto add = [&](const Color3f& radiance) {
        const Color3f part = pending.weight * radiance;
        result.radiance += Color4f(part.x, part.y, part.z, 0.0F);
    };
    const bool seen_directly = pending.reflections == 0;
    if (!hit.any()) {
        if (!seen_directly || settings_->background) {
            add(settings_->background.value_or(settings_->ambient));
        }
        return;
    }
    const Surface surface = traced_->surfaces.find(hit, pending.ray.direction);
    PositionDifferentials moved;
    TextureFootprint footprint{surface.texture_point, V2f(0.0F), V2f(0.0F)};
    if (traced_->textured) {
        moved = surface.transfer(pending.ray);
        footprint = surface.texture_footprint(moved);
    }
    const Appearance appearance = look_up(*surface.material, *traced_->textures, footprint, cache_);
    const float opacity = pending.crossings < max_crossings ? appearance.opacity : 1.0F;
    if (opacity < 1.0F) {
        follow_through(pending, surface, moved, opacity);
    }
    if (opacity <= 0.0F) {
        return;
    }
    if (seen_directly) {
        result.radiance.a += pending.weight.x * opacity;
        if (!result.visible.any) {
            result.visible = {true, surface.position, surface.normal, appearance.base_color,
                              surface.object + 1};
        }
    }
    add(opacity * shade(pending.ray, surface, appearance));
    if (settings_->integrator == Integrator::direct && appearance.smooth()) {
        Pending weakened = pending;
        weakened.weight *= opacity;
        follow_reflection(weakened, surface, moved, appearance);
    }
}

void Tracer::follow_through(const Pending& pending, const Surface& surface,
                            const PositionDifferentials& moved, float opacity) {
    Pending next = pending;
    next.weight *= 1.0F - opacity;
    ++next.crossings;
    next.ray.origin = surface.start(next.ray.direction);
    next.ray.differentials.origin_x = moved.along_x;
    next.ray.differentials.origin_y = moved.along_y;
    pending_.push_back(next);
}

void Tracer::follow_reflection(const Pending& pending, const Surface& surface,
                               const PositionDifferentials& moved, const Appearance& appearance) {
    const V3f to_viewer = -pending.ray.direction;
    Pending next = pending;
    next.weight *= fresnel(appearance.normal_reflectance(), surface.normal.dot(to_viewer));
    if (pending.reflections >= settings_->mirror_depth || largest(next.weight) < min_weight) {
        return;
    }
    ++next.reflections;
    V3f normal = surface.normal;
    if (mirrored(pending.ray.direction, normal).dot(surface.geometric_normal) <= 0.0F) {
        normal = surface.geometric_normal;
    }
    const RayDifferentials& before = pending.ray.differentials;
    next.ray.direction = mirrored(pending.ray.direction, normal).normalized();
    next.ray.origin = surface.start(next.ray.direction);
    next.ray.differentials = {moved.along_x, moved.along_y, mirrored(before.direction_x, normal),
                              mirrored(before.direction_y, normal)};
    pending_.push_back(next);
}

Color3f Tracer::shade(const Ray& ray, const Surface& surface, const Appearance& appearance) const {
    if (settings_->integrator == Integrator::preview) {
        const float cosine = std::abs(surface.normal.dot(ray.direction));
        return cosine * appearance.base_color + appearance.emission;
    }
    // A mirror gets its surroundings by reflection, everything else as a mean from all sides.
    const Color3f from_surroundings =
        appearance.diffuse() +
        (appearance.smooth() ? 0.0F : appearance.metallic) * appearance.base_color;
    return appearance.emission + settings_->ambient * from_surroundings +
           light(ray, surface, appearance);
}

Color3f Tracer::light(const Ray& ray, const Surface& surface, const Appearance& appearance) const {
    const V3f to_viewer = -ray.direction;
    Color3f total(0.0F);
    if (traced_->scene->default_light) {
        // Such that a white wall seen straight on has radiance 1.
        total +=
            std::numbers::pi_v<float> * reflected(appearance, surface.normal, to_viewer, to_viewer);
    }
    for (const scene::Light& lamp : traced_->scene->lights) {
        const Illumination arriving =
            illuminate(lamp, surface.position, traced_->scene->meters_per_unit);
        if (largest(arriving.irradiance) <= 0.0F ||
            arriving.to_light.dot(surface.geometric_normal) <= 0.0F) {
            continue;
        }
        const Color3f unshadowed = arriving.irradiance * reflected(appearance, surface.normal,
                                                                   to_viewer, arriving.to_light);
        if (largest(unshadowed) <= 0.0F) {
            continue;
        }
        total += unshadowed * traced_->accelerator.transmittance(
                                  {surface.start(arriving.to_light), arriving.to_light,
                                   nearly_all * arriving.distance},
                                  *this);
    }
    return total;
}

float Tracer::opacity(const embree::Hit& hit) const {
    const TextureFootprint point{traced_->surfaces.texture_point(hit), V2f(0.0F), V2f(0.0F)};
    return look_up_opacity(traced_->surfaces.material(hit), *traced_->textures, point, cache_);
}

}  // namespace balcony::render
