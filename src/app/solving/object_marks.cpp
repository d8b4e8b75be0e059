// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/solving/object_marks.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "app/solving/outline_points.hpp"
#include "app/words.hpp"
#include "balcony/inputs.hpp"
#include "balcony/object_names.hpp"
#include "balcony/scene.hpp"

namespace balcony::app {

namespace {

using solve::V3d;

// The box of some objects: that of the scene without the others.
scene::Box3f box_of(scene::Scene scene, const std::vector<std::uint32_t>& objects) {
    std::erase_if(scene.instances, [&objects](const scene::Instance& one) {
        return std::find(objects.begin(), objects.end(), one.object) == objects.end();
    });
    return scene.bounds();
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
    const auto objects_of = [&](const auto& one) {
        std::vector<std::uint32_t> objects = scene::objects_named(*scene, one.object);
        if (objects.empty()) {
            found.push_back(scene::no_object(
                *scene, fmt::format("'{}' has no object '{}'", scene->name, printable(one.object)),
                one.object, one.written));
        }
        return objects;
    };
    for (const Marks::OnObject& one : marks.on_objects) {
        if (const auto objects = objects_of(one); !objects.empty()) {
            marks.problem.marks[one.mark].place =
                turned(place_in(box_of(*scene, objects), one.part), scene->axes, *marks.axes);
        }
    }
    for (const Marks::OutlineOfObject& one : marks.outlines_of_objects) {
        if (const auto objects = objects_of(one); !objects.empty()) {
            std::vector<V3d>& points = marks.problem.outlines[one.outline].points;
            for (const V3d& point : outline_points(*scene, objects)) {
                points.push_back(turned(point, scene->axes, *marks.axes));
            }
        }
    }
    return found;
}

Diagnostics place_directions(Marks& marks) {
    Diagnostics found;
    for (const Marks::Direction& one : marks.directions) {
        const solve::Mark& from = marks.problem.marks[one.ends[0]];
        const solve::Mark& to = marks.problem.marks[one.ends[1]];
        V3d& direction = marks.problem.marks[one.mark].place;
        direction = to.place - from.place;
        if (!(direction.length2() > 0.0)) {
            found.push_back(
                error(fmt::format("the marks '{}' and '{}' are at one place", from.name, to.name),
                      one.written, "write two marks that are apart"));
        }
    }
    return found;
}

}  // namespace balcony::app
