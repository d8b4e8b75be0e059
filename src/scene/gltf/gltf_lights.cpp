// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "scene/gltf/gltf_reader.hpp"
#include "scene/placement.hpp"

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

// KHR_lights_punctual: the node's scale changes neither a light's intensity nor its range.
Light read_light(const Json& json, const M44d& world_from_node) {
    Light light;
    light.kind = kind_of(text_in(json, "type"));
    if (auto fault = place(light, world_from_node)) {
        throw PartError{std::move(*fault)};
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
    const Json& angle = member(member(json, "extras"), "angle");
    if (angle.is_number()) {
        light.angle = static_cast<float>(std::clamp(angle.get<double>(), 0.0, std::numbers::pi));
    }
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
