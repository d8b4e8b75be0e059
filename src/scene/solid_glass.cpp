// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "scene/import.hpp"

namespace balcony::scene {

namespace {

bool is_thin_glass(const Scene& scene, const Mesh& mesh) {
    const Material& material = scene.materials[mesh.material.value()];
    return material.transmission > 0.0F && material.thin_walled;
}

// Unlike a pane, which is flat even if it is closed.
bool is_curved(const Mesh& mesh) {
    constexpr float flat = 0.9999F;  // Within a degree.
    return !mesh.normals.empty() &&
           std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& corners) {
               const auto normal = [&](std::size_t i) { return mesh.normals[corners[i]]; };
               return normal(0).dot(normal(1)) < flat || normal(1).dot(normal(2)) < flat;
           });
}

std::set<std::uint32_t> closed_thin_glass(const Scene& scene) {
    std::vector<bool> is_candidate;
    for (const Mesh& mesh : scene.meshes) {
        is_candidate.push_back(is_thin_glass(scene, mesh) && is_curved(mesh));
    }
    std::set<std::uint32_t> objects;
    for (const Instance& instance : scene.instances) {
        if (is_candidate[instance.mesh.value()]) {
            objects.insert(instance.object);
        }
    }
    std::erase_if(objects, [&](std::uint32_t object) { return !encloses_volume(scene, object); });
    return objects;
}

// Other objects of the same material stay thin.
void make_solid(Scene& scene, const std::set<std::uint32_t>& objects) {
    std::map<std::size_t, MaterialIndex> solids;
    for (const Instance& instance : scene.instances) {
        Shared<Mesh>& mesh = scene.meshes[instance.mesh.value()];
        if (!objects.contains(instance.object) || !is_thin_glass(scene, mesh)) {
            continue;
        }
        const auto [solid, is_new] =
            solids.try_emplace(mesh->material.value(), scene.materials.size());
        if (is_new) {
            scene.materials.push_back(scene.materials[mesh->material.value()]);
            scene.materials.back().thin_walled = false;
        }
        mesh.edit().material = solid->second;
    }
}

}  // namespace

void treat_glass(Import& import) {
    const std::optional<bool> solid = import.options.solid_glass;
    if (!solid.value_or(import.is_of_blender)) {
        return;
    }
    const std::set<std::uint32_t> objects = closed_thin_glass(import.scene);
    if (objects.empty()) {
        return;
    }
    if (solid) {
        make_solid(import.scene, objects);
        return;
    }
    const std::string others =
        objects.size() > 1 ? fmt::format(" and {}", counted(objects.size() - 1, "other object"))
                           : std::string();
    import.warn(fmt::format("the glass of {}{} has no volume in the file, so it is thin and does "
                            "not refract",
                            in_quotes(import.scene.objects[*objects.begin()].name), others),
                "--glass solid makes closed objects solid, --glass thin keeps them as they are");
}

}  // namespace balcony::scene
