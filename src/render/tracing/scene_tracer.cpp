// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/tracing/scene_tracer.hpp"

#include <cmath>

namespace balcony::render {

VisibleSurface SceneTracer::visible(const Interaction& at) const {
    const auto material = at.surface.material - traced_->scene->materials.data();
    return {true,
            at.surface.position,
            at.surface.normal,
            at.appearance().base_color,
            at.surface.object + 1,
            static_cast<std::uint32_t>(material) + 1,
            at.surface.instance,
            at.surface.in_mesh.triangle,
            at.surface.in_mesh.u,
            at.surface.in_mesh.v};
}

Interaction::Interaction(const TracedScene& traced, const DifferentialRay& ray,
                         const embree::Hit& hit)
    : surface(traced.surfaces.find(hit, ray.direction, ray.time)) {
    const MaterialSet& materials = traced.materials;
    if (materials.has_textures()) {
        moved = surface.transfer(ray);
    }
    const scene::Mesh& mesh = *surface.in_mesh.mesh;
    constant = materials.constant(mesh);
    if (constant != nullptr) {
        uniform = materials.uniform_bsdf(mesh, surface.entering);
    } else {
        varying = materials.look_up(surface, moved, -ray.direction);
    }
}

Bsdf Interaction::bsdf() const {
    Bsdf made = uniform != nullptr
                    ? Bsdf(*uniform, surface.normal, surface.smooth_normal)
                    : Bsdf(appearance(), surface.normal, surface.smooth_normal, surface.entering);
    made.set_coat_normal(surface.coat_normal);
    return made;
}

Color3f Interaction::straight(const V3f& direction) const {
    const auto passed = appearance().unlit || !appearance().thin_walled
                            ? std::nullopt
                            : bsdf().sample_passage(-direction);
    return passed ? passed->weight : Color3f(0.0F);
}

Color3f SceneTracer::emission(const embree::Hit& hit, const V3f& direction, float time) const {
    const MeshPoint point = traced_->surfaces.mesh_point(hit);
    if (traced_->scene->materials[point.mesh->material.value()].clearcoat > 0.0F) {
        const Interaction at(*traced_, DifferentialRay{V3f(0.0F), direction, {}, time}, hit);
        return at.appearance().opacity * at.emission(direction);
    }
    return traced_->materials.opacity(point) * traced_->materials.emission(point);
}

embree::Ray SceneTracer::shadow_ray(const Surface& surface, const V3f& to_light, float distance,
                                    float time) {
    if (to_light.dot(surface.smooth_normal) < 0.0F) {
        return {surface.start(to_light), to_light, nearly_all * distance, time};
    }
    const V3f start = surface.start_to_light();
    if (std::isinf(distance)) {
        return {start, to_light, distance, time};
    }
    // Towards the same point of the light: at a grazing angle the offset would lead behind it.
    const V3f way = distance * to_light - (start - surface.position);
    return {start, way.normalized(), nearly_all * way.length(), time};
}

Color3f SceneTracer::transmittance(const Surface& surface, const V3f& to_light, float distance,
                                   float time) const {
    return distance > 0.0F ? transmittance(shadow_ray(surface, to_light, distance, time))
                           : Color3f(1.0F);
}

Color3f SceneTracer::Openings::transmittance(const embree::Hit& hit, const embree::Ray&) const {
    return Color3f(1.0F - traced->materials.opacity(traced->surfaces.mesh_point(hit)));
}

Color3f SceneTracer::Glass::transmittance(const embree::Hit& hit, const embree::Ray&) const {
    const MeshPoint point = traced->surfaces.mesh_point(hit);
    return Color3f(is_glass(traced->scene->materials[point.mesh->material.value()]) ? 1.0F : 0.0F);
}

float SceneTracer::pdf_behind_glass(const LitPoint& from, const embree::Ray& ray) const {
    embree::Ray beyond = ray;
    for (std::size_t crossings = 0; crossings < max_crossings; ++crossings) {
        const embree::Hit hit = traced_->accelerator.intersect(beyond);
        if (!hit.any()) {
            return lights().pdf_of_distant(from, ray.direction);
        }
        const Surface surface = traced_->surfaces.find(hit, ray.direction, ray.time);
        if (!is_glass(*surface.material)) {
            return lights().pdf_of_emitter(from, ray.direction,
                                           (surface.position - from.position).length(), hit);
        }
        beyond.origin = surface.start(ray.direction);
    }
    return 0.0F;
}

Color3f SceneTracer::Panes::transmittance(const embree::Hit& hit, const embree::Ray& ray) const {
    const MeshPoint point = traced->surfaces.mesh_point(hit);
    if (!may_be_pane(traced->scene->materials[point.mesh->material.value()])) {
        return Openings::transmittance(hit, ray);
    }
    const Interaction at(*traced, DifferentialRay{ray.origin, ray.direction, {}, ray.time}, hit);
    const float opacity = at.appearance().opacity;
    return Color3f(1.0F - opacity) + opacity * at.straight(ray.direction);
}

}  // namespace balcony::render
