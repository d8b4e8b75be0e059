// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/shading/lights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace balcony::render {

namespace {

// 1 inside the inner cone, 0 outside the outer one, and the extension's smooth step in between.
double cone_weight(const scene::Light& light, const scene::V3d& to_light) {
    const double inner = std::cos(static_cast<double>(light.inner_cone));
    const double outer = std::cos(static_cast<double>(light.outer_cone));
    const double cosine = -light.direction.dot(to_light);
    const double step = (cosine - outer) / std::max(inner - outer, 1e-6);
    const double weight = std::clamp(step, 0.0, 1.0);
    return weight * weight;
}

// The extension's window function, which reaches 0 at the light's range.
double range_weight(const scene::Light& light, double distance) {
    if (light.range <= 0.0F) {
        return 1.0;
    }
    const double ratio = distance / static_cast<double>(light.range);
    return std::clamp(1.0 - ratio * ratio * ratio * ratio, 0.0, 1.0);
}

Illumination from_lamp(const scene::Light& light, const Imath::V3f& position,
                       double meters_per_unit) {
    if (light.kind == scene::LightKind::directional) {
        return {Imath::V3f(-light.direction), std::numeric_limits<float>::infinity(),
                light.intensity};
    }
    const scene::V3d offset = light.position - scene::V3d(position);
    const double distance = offset.length();
    if (!(distance > 0.0 && distance <= double{std::numeric_limits<float>::max()})) {
        return {Imath::V3f(0.0F), 0.0F, Imath::Color3f(0.0F)};
    }
    const scene::V3d to_light = offset / distance;
    const double meters = distance * meters_per_unit;
    const double cone = light.kind == scene::LightKind::spot ? cone_weight(light, to_light) : 1.0;
    const double weight = cone * range_weight(light, distance) / (meters * meters);
    return {Imath::V3f(to_light), static_cast<float>(distance),
            light.intensity * static_cast<float>(weight)};
}

}  // namespace

Illumination LightSet::arriving(std::size_t light, const LitPoint& point) const {
    if (!scene_->default_light) {
        return from_lamp(scene_->lights[light], point.position, scene_->meters_per_unit);
    }
    if (light > 0) {
        return from_lamp(scene_->lights[light - 1], point.position, scene_->meters_per_unit);
    }
    // Such that a white wall seen frontally has radiance 1.
    return {point.to_viewer, 0.0F, Imath::Color3f(std::numbers::pi_v<float>)};
}

std::optional<LightSample> LightSet::sample(const LitPoint& point, float random) const {
    const std::size_t count = size();
    if (count == 0) {
        return std::nullopt;
    }
    const auto chosen = static_cast<std::size_t>(random * static_cast<float>(count));
    return LightSample{arriving(std::min(chosen, count - 1), point),
                       1.0F / static_cast<float>(count)};
}

}  // namespace balcony::render
