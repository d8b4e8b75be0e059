// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Materials and lights, after whose edits the scene may have a light or none.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/precondition.hpp"
#include "scene/default_light.hpp"
#include "scene/edits/edited_motion.hpp"
#include "scene/edits/parts_by_name.hpp"

namespace balcony::scene {

namespace {

void check_light(const Scene& scene, std::size_t light) {
    precondition(light < scene.lights.size(), "a scene has no light with this number");
}

bool is_used(const Scene& scene, std::size_t material) {
    return std::any_of(scene.meshes.begin(), scene.meshes.end(),
                       [material](const Mesh& mesh) { return mesh.material.value() == material; });
}

}  // namespace

Diagnostics set_material(Scene& scene, std::size_t material,
                         std::span<const PropertyValue> values) {
    precondition(material < scene.materials.size(), "a scene has no material with this number");
    Diagnostics found = set_properties(scene.materials[material], values);
    find_default_light(scene);
    return found;
}

Result<std::size_t> add_material(Scene& scene, const std::string& name,
                                 std::span<const PropertyValue> values) {
    Material made;
    made.name = name;
    if (Diagnostics found = set_properties(made, values); !found.empty()) {
        return found;
    }
    const auto same = std::find_if(scene.materials.begin(), scene.materials.end(),
                                   [&](const Material& one) { return one.name == name; });
    const auto number = static_cast<std::size_t>(same - scene.materials.begin());
    if (same != scene.materials.end() && !name.empty() && !is_used(scene, number)) {
        *same = std::move(made);
        return number;
    }
    if (Diagnostics found = refuse_material_name(scene, name); !found.empty()) {
        return found;
    }
    scene.materials.push_back(std::move(made));
    return number;
}

Diagnostics set_light(Scene& scene, std::size_t light, std::span<const PropertyValue> values) {
    check_light(scene, light);
    Diagnostics found = set_properties(scene.lights[light], values);
    const bool is_placed = std::any_of(values.begin(), values.end(), [](const PropertyValue& one) {
        return one.name == "position" || one.name == "direction";
    });
    if (found.empty() && is_placed) {
        stop_light(scene, light);
    }
    return found;
}

Result<std::size_t> add_light(Scene& scene, const std::string& name, LightKind kind,
                              std::span<const PropertyValue> values) {
    Light made{.name = name, .kind = kind};
    Diagnostics found = refuse_light_name(scene, name);
    if (found.empty()) {
        found = set_properties(made, values);
    }
    if (!found.empty()) {
        return found;
    }
    scene.lights.push_back(std::move(made));
    find_default_light(scene);
    return scene.lights.size() - 1;
}

void remove_light(Scene& scene, std::size_t light) {
    check_light(scene, light);
    scene.lights.erase(scene.lights.begin() + static_cast<std::ptrdiff_t>(light));
    renumber_lights(scene, [light](std::size_t number) {
        return number == light ? std::optional<std::size_t>()
                               : std::optional(number - (number > light ? 1 : 0));
    });
    find_default_light(scene);
}

}  // namespace balcony::scene
