// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "balcony/scene_edits.hpp"
#include "base/precondition.hpp"
#include "scene/default_light.hpp"
#include "scene/edits/edited_motion.hpp"
#include "scene/import.hpp"
#include "scene/placement.hpp"

namespace balcony::scene {

namespace {

bool is_affine(const M44d& matrix) {
    return matrix[0][3] == 0.0 && matrix[1][3] == 0.0 && matrix[2][3] == 0.0 && matrix[3][3] == 1.0;
}

void check_object(const Scene& scene, std::size_t object) {
    precondition(object < scene.objects.size(), "a scene has no object with this number");
}

std::vector<std::size_t> instances_of(const Scene& scene, std::size_t object) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        if (scene.instances[i].object == object) {
            found.push_back(i);
        }
    }
    return found;
}

Diagnostic no_place(const Scene& scene, std::size_t object) {
    return error(fmt::format("object {} has no mesh, so it stands nowhere",
                             in_quotes(scene.objects[object].name)));
}

// Gives the instances of an object new places, unless one of them cannot stand there.
template <class NewPlace>
Diagnostics place_instances(Scene& scene, const std::vector<std::size_t>& instances,
                            const NewPlace& new_place) {
    std::vector<M44d> places;
    for (const std::size_t i : instances) {
        const Instance& instance = scene.instances[i];
        places.push_back(new_place(instance.world_from_mesh));
        const PlacementFault fault =
            is_affine(places.back()) || !is_finite(places.back())
                ? fault_of_placement(box_of(scene.meshes[instance.mesh.value()]->positions),
                                     places.back())
                : PlacementFault("its transform is not affine");
        if (fault) {
            return {error(fmt::format("object {} cannot stand there: {}",
                                      in_quotes(scene.objects[instance.object].name), *fault))};
        }
    }
    for (std::size_t i = 0; i < instances.size(); ++i) {
        scene.instances[instances[i]].world_from_mesh = places[i];
    }
    return {};
}

// Removes elements of a vector by their numbers. Returns the new numbers of the others.
template <class Element>
NewNumber erase(std::vector<Element>& elements, const std::set<std::size_t>& gone) {
    std::vector<std::optional<std::size_t>> numbers;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const bool stays = !gone.contains(i);
        numbers.push_back(stays ? std::optional(kept) : std::nullopt);
        if (stays && kept != i) {
            elements[kept] = std::move(elements[i]);
        }
        kept += stays ? 1 : 0;
    }
    elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(kept), elements.end());
    return [numbers = std::move(numbers)](std::size_t number) { return numbers[number]; };
}

void remove_meshes(Scene& scene, std::set<std::size_t> gone) {
    for (const Instance& instance : scene.instances) {
        gone.erase(instance.mesh.value());
    }
    const NewNumber number = erase(scene.meshes, gone);
    for (Instance& instance : scene.instances) {
        instance.mesh = MeshIndex(*number(instance.mesh.value()));
    }
    renumber_meshes(scene, number);
}

}  // namespace

Result<M44d> place_of(const Scene& scene, std::size_t object) {
    check_object(scene, object);
    const auto instances = instances_of(scene, object);
    return instances.empty() ? Result<M44d>(no_place(scene, object))
                             : Result<M44d>(scene.instances[instances.front()].world_from_mesh);
}

Box3f bounds_of(const Scene& scene, std::size_t object) {
    check_object(scene, object);
    Box3f box;
    for (const std::size_t i : instances_of(scene, object)) {
        const Instance& instance = scene.instances[i];
        box.extendBy(
            box_of(scene.meshes[instance.mesh.value()]->positions, instance.world_from_mesh));
    }
    return box;
}

Diagnostics place_object(Scene& scene, std::size_t object, const M44d& world_from_object) {
    const Result<M44d> before = place_of(scene, object);
    if (!before) {
        return before.diagnostics;
    }
    const M44d change = before->inverse() * world_from_object;
    Diagnostics found =
        place_instances(scene, instances_of(scene, object), [&](const M44d& world_from_mesh) {
            return world_from_mesh == *before ? world_from_object : world_from_mesh * change;
        });
    if (found.empty()) {
        stop_object(scene, object);
    }
    return found;
}

Diagnostics transform_object(Scene& scene, std::size_t object, const M44d& change) {
    check_object(scene, object);
    const auto instances = instances_of(scene, object);
    if (instances.empty()) {
        return {no_place(scene, object)};
    }
    Diagnostics found = place_instances(
        scene, instances, [&](const M44d& world_from_mesh) { return world_from_mesh * change; });
    if (found.empty()) {
        transform_paths(scene, object, change);
    }
    return found;
}

void remove_object(Scene& scene, std::size_t object) {
    check_object(scene, object);
    std::set<std::size_t> instances;
    std::set<std::size_t> meshes;
    for (const std::size_t i : instances_of(scene, object)) {
        instances.insert(i);
        meshes.insert(scene.instances[i].mesh.value());
    }
    renumber_instances(scene, erase(scene.instances, instances));
    for (Instance& instance : scene.instances) {
        instance.object -= instance.object > object ? 1 : 0;
    }
    scene.objects.erase(scene.objects.begin() + static_cast<std::ptrdiff_t>(object));
    remove_meshes(scene, std::move(meshes));
    find_default_light(scene);
}

}  // namespace balcony::scene
