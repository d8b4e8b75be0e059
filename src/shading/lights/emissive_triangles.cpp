// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/lights/emissive_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "images/luminance.hpp"
#include "shading/geometry/placed.hpp"
#include "shading/textures/texture_library.hpp"

namespace balcony::render {

bool emits(const scene::Material& material) {
    const Color3f& e = material.emission;
    const float largest = std::max({e.x, e.y, e.z});
    return largest > 0.0F && std::isfinite(largest) && !material.unlit;
}

EmissiveTriangles::EmissiveTriangles(const scene::Scene& scene, const scene::Movement& movement,
                                     const std::stop_token& stop)
    : scene_(&scene), moving_(movement), shapes_(movement) {
    const auto triangles = [&scene](const scene::Instance& instance) -> std::size_t {
        const scene::Mesh& mesh = scene.meshes[instance.mesh.value()];
        return emits(scene.materials[mesh.material.value()]) ? mesh.triangles.size() : 0;
    };
    for (const scene::Instance& instance : scene.instances) {
        count_ += triangles(instance);
    }
    std::size_t first_triangle = 0;
    run_length_ = std::max<std::size_t>(1, (count_ + max_runs - 1) / max_runs);
    placements_.reserve(scene.instances.size());
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const std::size_t count = triangles(scene.instances[i]);
        const scene::Mesh& mesh = scene.meshes[scene.instances[i].mesh.value()];
        placements_.push_back({Imath::M44f(scene.instances[i].world_from_mesh),
                               &scene.materials[mesh.material.value()],
                               count > 0 ? runs_.size() : none, first_triangle});
        first_triangle += count;
        for (std::size_t first = 0; first < count; first += run_length_) {
            runs_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(first),
                             static_cast<std::uint32_t>(std::min(run_length_, count - first))});
        }
    }
    keep_triangles(stop);
    find_closed_objects(stop);
}

void EmissiveTriangles::keep_triangles(const std::stop_token& stop) {
    if (!moving_.empty() || !shapes_.empty() || count_ > max_runs) {
        return;
    }
    std::vector<WorldTriangle> all;
    all.reserve(count_);
    for (const EmissiveRun& run : runs_) {
        if (stop.stop_requested()) {
            return;
        }
        for (std::uint32_t i = 0; i < run.count; ++i) {
            all.push_back(placed_triangle(run.instance, run.first + i, 0.0F));
        }
    }
    at_rest_ = std::move(all);
}

std::optional<std::size_t> EmissiveTriangles::run_with(const embree::Hit& hit) const {
    const std::size_t first = placements_[hit.instance].first_run;
    return first == none ? std::nullopt : std::optional(first + hit.triangle / run_length_);
}

// An object that is large compared to the scene may be a sky around everything else.
void EmissiveTriangles::find_closed_objects(const std::stop_token& stop) {
    constexpr std::size_t max_triangles = 1'000'000;  // About a third of a second.
    constexpr float small = 0.25F;
    constexpr float middle = 0.5F;
    if (count_ == 0 || count_ > max_triangles) {
        return;
    }
    const Imath::Box3f all = scene_->bounds();
    std::vector<Imath::Box3f> boxes(scene_->objects.size());
    std::vector<std::uint8_t> candidates(scene_->objects.size(), 0);
    for (const EmissiveRun& run : runs_) {
        if (stop.stop_requested()) {
            return;
        }
        const std::uint32_t object = scene_->instances[run.instance].object;
        const scene::Material& surface = material(run.instance);
        candidates[object] = surface.alpha_mode == scene::AlphaMode::opaque ? 1 : 0;
        const WorldTriangle one = triangle(run.instance, run.first, middle);
        boxes[object].extendBy(one.corner);
        boxes[object].extendBy(one.corner + one.edge_1);
        boxes[object].extendBy(one.corner + one.edge_2);
    }
    for (std::uint32_t object = 0; object < candidates.size() && !stop.stop_requested(); ++object) {
        candidates[object] = candidates[object] != 0 &&
                                     boxes[object].size().length() < small * all.size().length() &&
                                     scene::encloses_volume(*scene_, object)
                                 ? 1
                                 : 0;
    }
    for (std::size_t i = 0; i < placements_.size(); ++i) {
        const scene::Instance& instance = scene_->instances[i];
        if (candidates[instance.object] != 0) {
            placements_[i].front = instance.world_from_mesh.determinant() < 0.0 ? -1.0F : 1.0F;
        }
    }
}

// The luminance that a triangle emits. The mean of a texture may miss what is between its samples,
// so a part is certain.
float EmissiveTriangles::emitted(const EmissiveRun& run, std::uint32_t triangle,
                                 const TextureLibrary* textures) const {
    constexpr float certain = 0.02F;
    const scene::Material& surface = material(run.instance);
    const scene::Mesh& mesh = scene_->meshes[scene_->instances[run.instance].mesh.value()];
    const scene::TextureUse& texture = surface.emission_texture;
    const float white = luminance(surface.emission);
    if (textures == nullptr || !texture.valid() ||
        mesh.texture_coordinates[texture.coordinates].empty()) {
        return white;
    }
    const auto& corners = mesh.triangles[triangle];
    const auto& coordinates = mesh.texture_coordinates[texture.coordinates];
    const Imath::V2f at = texture.place(coordinates[corners[0]]);
    const Imath::V2f edge_1 = texture.place(coordinates[corners[1]]) - at;
    const Imath::V2f edge_2 = texture.place(coordinates[corners[2]]) - at;
    const Imath::Color4f mean =
        textures->look_up(texture.index, texture.encoding,
                          {at + (edge_1 + edge_2) / 3.0F, 0.5F * edge_1, 0.5F * edge_2});
    const float found = luminance(surface.emission * Color3f(mean.r, mean.g, mean.b));
    return certain * white + (1.0F - certain) * std::clamp(found, 0.0F, white);
}

LightBounds EmissiveTriangles::bounds(const EmissiveRun& run,
                                      const TextureLibrary* textures) const {
    const float front = placements_[run.instance].front;
    const std::size_t steps = std::max(moving_.step_count(run.instance),
                                       shapes_.step_count(scene_->instances[run.instance].mesh));
    std::vector<LightBounds> all;
    all.reserve(run.count * steps);
    for (std::size_t step = 0; step < steps; ++step) {
        const float time =
            static_cast<float>(step) / static_cast<float>(std::max<std::size_t>(steps - 1, 1));
        for (std::uint32_t i = 0; i < run.count; ++i) {
            const WorldTriangle one = triangle(run.instance, run.first + i, time);
            const V3f across = one.across();
            const float power = 0.5F * across.length() * emitted(run, run.first + i, textures) /
                                static_cast<float>(steps);
            if (!(power > 0.0F) || !std::isfinite(power)) {
                continue;
            }
            LightBounds found;
            found.box.extendBy(one.corner);
            found.box.extendBy(one.corner + one.edge_1);
            found.box.extendBy(one.corner + one.edge_2);
            found.axis = (front < 0.0F ? -across : across).normalized();
            found.cosine_falloff = 0.0F;
            found.two_sided = front == 0.0F;
            found.power = power;
            all.push_back(found);
        }
    }
    return bounds_of(all);
}

WorldTriangle EmissiveTriangles::placed_triangle(std::uint32_t instance, std::uint32_t triangle,
                                                 float time) const {
    const scene::MeshIndex index = scene_->instances[instance].mesh;
    const scene::Mesh& mesh = scene_->meshes[index.value()];
    const auto& corners = mesh.triangles[triangle];
    const std::optional<Imath::M44f> moved =
        moving_.empty() ? std::nullopt : moving_.world_from_mesh(instance, time);
    const std::optional<MeshCorners> shape =
        shapes_.empty() ? std::nullopt : shapes_.corners(index, corners, time);
    const Imath::M44f& world_from_mesh = moved ? *moved : placements_[instance].world_from_mesh;
    const auto corner = [&](std::size_t i) {
        return placed(shape ? shape->positions[i] : mesh.positions[corners[i]], world_from_mesh);
    };
    const V3f p0 = corner(0);
    return {p0, corner(1) - p0, corner(2) - p0};
}
}  // namespace balcony::render
