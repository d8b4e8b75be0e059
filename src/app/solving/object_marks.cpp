// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/solving/object_marks.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "app/words.hpp"
#include "balcony/inputs.hpp"
#include "balcony/names.hpp"
#include "balcony/scene.hpp"

namespace balcony::app {

namespace {

using solve::V3d;

// The box of an object: that of the scene without the other objects.
scene::Box3f box_of(scene::Scene scene, std::size_t object) {
    std::erase_if(scene.instances,
                  [object](const scene::Instance& one) { return one.object != object; });
    return scene.bounds();
}

Diagnostic no_object(const Marks::OnObject& mark, const scene::Scene& scene) {
    std::vector<std::string> names;
    for (const scene::Object& one : scene.objects) {
        names.push_back(one.name);
    }
    return error(fmt::format("'{}' has no object '{}'", scene.name, mark.object), mark.written,
                 did_you_mean(mark.object, names,
                              fmt::format("'balcony info {} --objects' lists them", scene.name)));
}

V3d place_in(const scene::Box3f& box, const V3d& part) {
    const V3d center = 0.5 * (V3d(box.min) + V3d(box.max));
    return center + 0.5 * (V3d(box.max) - V3d(box.min)) * part;
}

}  // namespace

std::filesystem::path scene_of(const Marks& marks, const std::filesystem::path& folder) {
    return marks.scene.empty() ? std::filesystem::path() : folder / marks.scene;
}

Diagnostics place_on_objects(Marks& marks, const std::filesystem::path& file,
                             const std::stop_token& stop) {
    if (file.empty()) {
        return {};
    }
    const Result<scene::Scene> scene = load_scene(file.string(), 0.0, {}, {}, stop);
    Diagnostics found = scene.diagnostics;
    if (!scene) {
        return found;
    }
    marks.axes = marks.axes.value_or(scene->axes);
    for (const Marks::OnObject& one : marks.on_objects) {
        const auto object = std::find_if(
            scene->objects.begin(), scene->objects.end(),
            [&](const scene::Object& candidate) { return candidate.name == one.object; });
        if (object == scene->objects.end()) {
            found.push_back(no_object(one, *scene));
            continue;
        }
        const auto index = static_cast<std::size_t>(object - scene->objects.begin());
        marks.problem.marks[one.mark].place =
            turned(place_in(box_of(*scene, index), one.part), scene->axes, *marks.axes);
    }
    return found;
}

}  // namespace balcony::app
