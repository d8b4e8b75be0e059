// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/names/scene_names.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace balcony::lang {

namespace {

Value number(double value, expr::Graph& graph) { return {graph.constant(value)}; }

template <class Values, class MakeElement>
Value compound(Value::Form form, const Values& values, const MakeElement& make_element) {
    std::vector<Element> elements;
    for (const auto& value : values) {
        elements.push_back({make_element(value), {}});
    }
    Value made;
    made.form = form;
    made.elements = std::make_shared<const std::vector<Element>>(std::move(elements));
    return made;
}

template <std::size_t n>
Value tuple(const std::array<double, n>& values, expr::Graph& graph) {
    return compound(Value::Form::tuple, values, [&graph](double x) { return number(x, graph); });
}

// A point given with z up. A camera with y up calls (x, z, -y) what one with z up calls (x, y, z).
std::array<double, 3> in_axes(const std::array<double, 3>& p, Axes axes) {
    return axes == Axes::z_up ? p : std::array{p[0], p[2], -p[1]};
}

double length_of(const std::vector<std::array<double, 2>>& line) {
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        length += std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
    }
    return length;
}

// If there is none, that of the upright cylinder around everything, without its centre and length.
SceneMeasures::Revolution revolution_of(const SceneMeasures& scene) {
    using std::numbers::pi;
    return scene.revolution.value_or(SceneMeasures::Revolution{.radius = scene.radius,
                                                               .reach = scene.radius,
                                                               .arc_middle = pi,
                                                               .arc = 2.0 * pi,
                                                               .profile = scene.profile});
}

}  // namespace

void define_scene_names(const SceneMeasures& scene, Axes axes, expr::Graph& graph, Scope& scope) {
    const auto define = [&scope](std::string_view name, Value value) {
        scope.define(name, {std::move(value), {}, "measure of a scene", true});
    };
    const std::array from = in_axes(scene.min, axes);
    const std::array to = in_axes(scene.max, axes);
    std::array<double, 3> min{};
    std::array<double, 3> max{};
    std::array<double, 3> center{};
    std::array<double, 3> size{};
    for (std::size_t i = 0; i < 3; ++i) {
        min[i] = std::min(from[i], to[i]);
        max[i] = std::max(from[i], to[i]);
        center[i] = 0.5 * (min[i] + max[i]);
        size[i] = max[i] - min[i];
    }
    define("scene_min", tuple(min, graph));
    define("scene_max", tuple(max, graph));
    define("scene_center", tuple(center, graph));
    define("scene_size", tuple(size, graph));
    define("scene_inside", tuple(in_axes(scene.inside, axes), graph));
    Value angle = number(scene.angle, graph);
    angle.unit = Unit::angle;
    define("scene_angle", std::move(angle));
    const auto line = [&graph](const std::vector<std::array<double, 2>>& points) {
        return compound(Value::Form::list, points, [&graph](const std::array<double, 2>& point) {
            return tuple(point, graph);
        });
    };
    define("scene_radius", number(scene.radius, graph));
    define("scene_profile", line(scene.profile));
    define("scene_profile_length", number(length_of(scene.profile), graph));

    const SceneMeasures::Revolution revolution = revolution_of(scene);
    define("scene_axis", tuple(in_axes(revolution.axis, axes), graph));
    define("scene_axis_center",
           tuple(scene.revolution ? in_axes(revolution.center, axes) : center, graph));
    define("scene_axis_length",
           number(scene.revolution ? revolution.length : scene.max[2] - scene.min[2], graph));
    define("scene_axis_radius", number(revolution.radius, graph));
    define("scene_axis_reach", number(revolution.reach, graph));
    define("scene_axis_profile", line(revolution.profile));
    define("scene_axis_profile_length", number(length_of(revolution.profile), graph));
    define("scene_arc",
           compound(Value::Form::tuple, std::array{revolution.arc_middle, revolution.arc},
                    [&graph](double x) {
                        Value made = number(x, graph);
                        made.unit = Unit::angle;
                        return made;
                    }));
}

std::span<const std::string_view> scene_names() {
    static constexpr std::array<std::string_view, 17> names = {"scene_min",
                                                               "scene_max",
                                                               "scene_center",
                                                               "scene_size",
                                                               "scene_inside",
                                                               "scene_angle",
                                                               "scene_radius",
                                                               "scene_profile",
                                                               "scene_profile_length",
                                                               "scene_axis",
                                                               "scene_axis_center",
                                                               "scene_axis_length",
                                                               "scene_axis_radius",
                                                               "scene_axis_reach",
                                                               "scene_axis_profile",
                                                               "scene_axis_profile_length",
                                                               "scene_arc"};
    return names;
}

void announce_scene_names(Scope& scope) {
    for (const std::string_view name : scene_names()) {
        scope.announce(name, "it is known in fit statements only");
    }
}

}  // namespace balcony::lang
