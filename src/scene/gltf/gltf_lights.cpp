// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "scene/gltf/gltf_reader.hpp"

namespace balcony::scene {

namespace {

LightKind kind_of(const std::string& type) {
    if (type == "point") {
        return LightKind::point;
    }
    if (type == "spot") {
        return LightKind::spot;
    }
    if (type == "directional") {
        return LightKind::directional;
    }
    throw PartError{fmt::format("its type {} is unknown", in_quotes(type))};
}

// KHR_lights_punctual: a light is at its node's origin and shines along the node's -z; the
// node's scale changes neither its intensity nor its range.
Light read_light(const Json& json, const M44d& world_from_node) {
    Light light;
    light.kind = kind_of(text_in(json, "type"));
    light.position = V3d(0.0) * world_from_node;
    V3d direction;
    world_from_node.multDirMatrix(V3d(0.0, 0.0, -1.0), direction);
    if (!(direction.length() > 0.0 && std::isfinite(direction.length()))) {
        throw PartError{"its node's transform gives it no direction"};
    }
    light.direction = direction.normalized();
    for (const double coordinate : {light.position.x, light.position.y, light.position.z}) {
        if (std::abs(coordinate) > max_coordinate) {
            throw PartError{fmt::format("it is further than {:g} from the origin", max_coordinate)};
        }
    }
    light.intensity = scaled(color_in(json, "color", Color3f(1.0F)),
                             quantity_in(json, "intensity", 1.0F), "intensity");
    light.range = quantity_in(json, "range", 0.0F);

    constexpr double quarter = std::numbers::pi / 2.0;
    const Json& spot = member(json, "spot");
    const double outer = number_in(spot, "outerConeAngle", std::numbers::pi / 4.0);
    const double inner = number_in(spot, "innerConeAngle", 0.0);
    light.outer_cone = static_cast<float>(std::clamp(outer, 0.0, quarter));
    light.inner_cone = static_cast<float>(std::clamp(inner, 0.0, std::clamp(outer, 0.0, quarter)));
    return light;
}

}  // namespace

void GltfReader::place_light(const Json& node, const M44d& world_from_node) {
    const Json& use = member(member(node, "extensions"), "KHR_lights_punctual");
    if (!use.is_object()) {
        return;
    }
    std::string name = text_in(node, "name");
    try {
        const Json& lights = member(member(root_, "extensions"), "KHR_lights_punctual");
        const Json& json = element(lights, "lights", count_in(use, "light", 0));
        if (name.empty()) {
            name = text_in(json, "name");
        }
        Light light = read_light(json, world_from_node);
        light.name = name;
        scene_.lights.push_back(std::move(light));
    } catch (const PartError& fault) {
        import_.warn(fmt::format("light {} is skipped: {}", in_quotes(name), fault.reason));
    }
}

}  // namespace balcony::scene
