// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/text/camera_formulas.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace balcony::bridge {

namespace {

using camera::StageValues;
using expr::Graph;
using expr::NodeId;

// The statement of a stage and the words for its port, which follow from its place in the camera
// and from whether it is the first one there with values of its kind.
struct Role {
    std::string_view statement;
    std::string_view port;
};

Role role_of(StageValues::Owner owner, bool point, bool first) {
    if (owner == StageValues::Owner::look) {
        return {"look", "direction rule"};
    }
    if (!point) {
        return first ? Role{"map", "picture mapper"} : Role{"warp", "parameter transformer"};
    }
    const bool eye = owner == StageValues::Owner::eye;
    return first ? Role{eye ? "eye" : "toward", "object generator"}
                 : Role{"move", "object transformer"};
}

// u and v, eye_x, toward_u, look_z, ...; from the second stage on with its number.
std::vector<std::string> names_of(StageValues::Owner owner, std::size_t count, std::size_t number) {
    static constexpr std::array parameters{"u", "v"};
    static constexpr std::array coordinates{"x", "y", "z"};
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i) {
        const char* axis = count == 2 ? parameters[i] : coordinates[i];
        std::string name = owner == StageValues::Owner::look     ? fmt::format("look_{}", axis)
                           : owner == StageValues::Owner::toward ? fmt::format("toward_{}", axis)
                           : count == 2                          ? axis
                                                                 : fmt::format("eye_{}", axis);
        names.push_back(number == 1 ? name : fmt::format("{}_{}", name, number));
    }
    return names;
}

std::vector<StageFormulas> named_stages(const camera::Camera& camera,
                                        const std::vector<StageValues>& stages) {
    std::vector<StageFormulas> made;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const StageValues& stage = stages[i];
        const auto same = [&](const StageValues& other) {
            return other.owner == stage.owner && other.values.size() == stage.values.size();
        };
        const auto number = static_cast<std::size_t>(
            1 +
            std::count_if(stages.begin(), stages.begin() + static_cast<std::ptrdiff_t>(i), same));
        const Role role = role_of(stage.owner, stage.values.size() == 3, number == 1);
        const auto& written = camera.parts().written;
        const auto found = written.find(stage.stage);
        std::string text = fmt::format("{} ({})", role.statement, role.port);
        if (found != written.end()) {
            text = found->second.starts_with("map ")
                       ? found->second
                       : fmt::format("{} {}", role.statement, found->second);
        }
        made.push_back({fmt::format("the {}", role.port), text, stage.values,
                        names_of(stage.owner, stage.values.size(), number)});
    }
    return made;
}

// What no formula can express: functions without one, and what only a scene knows.
Diagnostics inexpressible(const CameraFormulas& made, const camera::Camera& camera) {
    const auto object = made.lens ? camera.parts().lens->focus().object() : std::nullopt;
    if (object) {
        return {error(fmt::format("the lens of the camera '{}' cannot be exported: it focuses on "
                                  "the object '{}' of a scene",
                                  camera.name(), *object),
                      camera.parts().lens_span,
                      "focus at a distance or on a point: lens(0.1, focus = 5)")};
    }
    const Graph& graph = *made.graph;
    for (const NodeId id : expr::reachable(graph, made.roots)) {
        const expr::Node& node = graph[id];
        if (node.op == Op::call && graph.call_of(id).native) {
            const StageFormulas* stage = stage_with(made, id);
            return {error(
                fmt::format("'{}' of the camera '{}' cannot be exported: '{}' is a search in data, "
                            "which has no formula",
                            stage != nullptr ? stage->written : "a stage", camera.name(),
                            graph.call_of(id).native->name()),
                {},
                "give the rays themselves to the other program with 'balcony rays', or replace "
                "this object by a surface with a formula")};
        }
    }
    return {};
}

void add_footprints(Graph& graph, std::vector<Expr>& roots) {
    const auto at = [&roots](std::size_t i) { return roots[i]; };
    const auto [o, d] = std::pair(RayRoots::origin, RayRoots::direction);
    const camera::RayFootprint slopes = camera::footprint({{at(o), at(o + 1), at(o + 2)},
                                                           {at(d), at(d + 1), at(d + 2)},
                                                           at(RayRoots::valid),
                                                           {graph.picture_x(), graph.picture_y()}});
    std::vector<Expr> added;
    for (const camera::ObjectVector& v :
         {slopes.origin_by_x, slopes.origin_by_y, slopes.direction_by_x, slopes.direction_by_y}) {
        added.insert(added.end(), {v.x, v.y, v.z});
    }
    added = expr::simplify(added);
    roots.insert(roots.end(), added.begin(), added.end());
}

CameraFormulas emitted(const camera::Camera& camera, const FormulaRequest& request) {
    CameraFormulas made;
    made.graph = std::make_unique<Graph>();
    Graph& graph = *made.graph;
    const camera::PicturePoint picture{{graph.picture_x(), graph.picture_y()},
                                       {graph.input(width_input), graph.input(height_input)}};
    const camera::RayExpressions ray = camera.emit(picture);
    made.lens = ray.lens.has_value();
    made.stages = named_stages(camera, camera.emit_stages(picture));
    made.axes = request.axes;
    std::vector<Expr> all =
        rays::ray_roots(ray, made.lens, request.footprints, camera.parts().axes, request.axes);
    const std::size_t root_count = all.size();
    for (const StageFormulas& stage : made.stages) {
        all.insert(all.end(), stage.values.begin(), stage.values.end());
    }
    all = expr::simplify(all);
    made.roots.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(root_count));
    if (request.measured && !request.footprints) {
        add_footprints(graph, made.roots);
    }
    std::size_t next = root_count;
    for (StageFormulas& stage : made.stages) {
        for (Expr& value : stage.values) {
            value = all[next++];
        }
    }
    return made;
}

}  // namespace

Diagnostic too_large_error(std::string_view camera) {
    return error(fmt::format("camera '{}' is too large to be exported", camera), {},
                 "repeat fewer stages, or give its rays with 'balcony rays'");
}

const StageFormulas* stage_with(const CameraFormulas& made, NodeId node) {
    for (const StageFormulas& stage : made.stages) {
        const std::vector<NodeId> nodes = expr::reachable(*made.graph, stage.values);
        if (std::find(nodes.begin(), nodes.end(), node) != nodes.end()) {
            return &stage;
        }
    }
    return nullptr;
}

Result<CameraFormulas> formulas_of(const camera::Camera& camera, const FormulaRequest& request) {
    if (camera.parts().bend) {
        return error(
            fmt::format("the camera '{}' cannot be exported to '{}': its rays are bent, and "
                        "'{}' holds straight rays only",
                        camera.name(), request.target, request.target),
            camera.parts().bend_span, "remove its bend, or make its picture with 'balcony render'");
    }
    try {
        CameraFormulas made = emitted(camera, request);
        Diagnostics found = inexpressible(made, camera);
        if (!found.empty()) {
            return found;
        }
        return made;
    } catch (const expr::GraphTooLarge&) {
        return too_large_error(camera.name());
    }
}

}  // namespace balcony::bridge
