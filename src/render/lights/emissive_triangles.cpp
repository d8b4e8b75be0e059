// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/lights/emissive_triangles.hpp"

#include <algorithm>
#include <cmath>

#include "render/film/luminance.hpp"

namespace balcony::render {

namespace {

V3f placed(const V3f& p, const Imath::M44f& m) {
    return {p.x * m[0][0] + p.y * m[1][0] + p.z * m[2][0] + m[3][0],
            p.x * m[0][1] + p.y * m[1][1] + p.z * m[2][1] + m[3][1],
            p.x * m[0][2] + p.y * m[1][2] + p.z * m[2][2] + m[3][2]};
}

}  // namespace

bool emits(const scene::Material& material) {
    const Color3f& e = material.emission;
    const float largest = std::max({e.x, e.y, e.z});
    return largest > 0.0F && std::isfinite(largest);
}

EmissiveTriangles::EmissiveTriangles(const scene::Scene& scene) : scene_(&scene) {
    const auto triangles = [&scene](const scene::Instance& instance) -> std::size_t {
        const scene::Mesh& mesh = scene.meshes[instance.mesh.value()];
        return emits(scene.materials[mesh.material.value()]) ? mesh.triangles.size() : 0;
    };
    std::size_t total = 0;
    for (const scene::Instance& instance : scene.instances) {
        total += triangles(instance);
    }
    run_length_ = std::max<std::size_t>(1, (total + max_runs - 1) / max_runs);
    placements_.reserve(scene.instances.size());
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const std::size_t count = triangles(scene.instances[i]);
        placements_.push_back(
            {Imath::M44f(scene.instances[i].world_from_mesh), count > 0 ? runs_.size() : none});
        for (std::size_t first = 0; first < count; first += run_length_) {
            runs_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(first),
                             static_cast<std::uint32_t>(std::min(run_length_, count - first))});
        }
    }
}

std::optional<std::size_t> EmissiveTriangles::run_with(const embree::Hit& hit) const {
    const std::size_t first = placements_[hit.instance].first_run;
    return first == none ? std::nullopt : std::optional(first + hit.triangle / run_length_);
}

LightBounds EmissiveTriangles::bounds(const EmissiveRun& run) const {
    const float emitted = luminance(material(run.instance).emission);
    std::vector<LightBounds> all;
    all.reserve(run.count);
    for (std::uint32_t i = 0; i < run.count; ++i) {
        const WorldTriangle one = triangle(run.instance, run.first + i);
        const V3f across = one.across();
        const float power = 0.5F * across.length() * emitted;
        if (!(power > 0.0F) || !std::isfinite(power)) {
            continue;
        }
        LightBounds found;
        found.box.extendBy(one.corner);
        found.box.extendBy(one.corner + one.edge_1);
        found.box.extendBy(one.corner + one.edge_2);
        found.axis = across.normalized();
        found.cosine_falloff = 0.0F;
        found.two_sided = true;
        found.power = power;
        all.push_back(found);
    }
    return bounds_of(all);
}

WorldTriangle EmissiveTriangles::triangle(std::uint32_t instance, std::uint32_t triangle) const {
    const scene::Mesh& mesh = scene_->meshes[scene_->instances[instance].mesh.value()];
    const Imath::M44f& world_from_mesh = placements_[instance].world_from_mesh;
    const auto corner = [&](std::size_t i) {
        return placed(mesh.positions[mesh.triangles[triangle][i]], world_from_mesh);
    };
    const V3f p0 = corner(0);
    return {p0, corner(1) - p0, corner(2) - p0};
}

const scene::Material& EmissiveTriangles::material(std::uint32_t instance) const {
    const scene::Mesh& mesh = scene_->meshes[scene_->instances[instance].mesh.value()];
    return scene_->materials[mesh.material.value()];
}

}  // namespace balcony::render
