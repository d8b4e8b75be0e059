// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/lights/punctual.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "images/luminance.hpp"

namespace balcony::render {

namespace {

// 1 inside the inner cone, 0 outside the outer one, and the extension's smooth step in between,
// which has at least the width of the extension's reference code.
double cone_weight(const scene::Light& lamp, const scene::V3d& to_light) {
    constexpr double min_width = 1e-3;
    const double inner = std::cos(static_cast<double>(lamp.inner_cone));
    const double outer = std::cos(static_cast<double>(lamp.outer_cone));
    const double cosine = -lamp.direction.dot(to_light);
    const double step = (cosine - outer) / std::max(inner - outer, min_width);
    const double weight = std::clamp(step, 0.0, 1.0);
    return weight * weight;
}

// The extension's window function, which reaches 0 at the light's range.
double range_weight(const scene::Light& lamp, double distance) {
    if (lamp.range <= 0.0F) {
        return 1.0;
    }
    const double ratio = distance / static_cast<double>(lamp.range);
    return std::clamp(1.0 - ratio * ratio * ratio * ratio, 0.0, 1.0);
}

}  // namespace

Illumination light_of(const scene::Light& lamp, const Imath::V3f& position,
                      double meters_per_unit) {
    if (lamp.kind == scene::LightKind::directional) {
        return {Imath::V3f(-lamp.direction), std::numeric_limits<float>::infinity(),
                lamp.intensity};
    }
    const scene::V3d offset = lamp.position - scene::V3d(position);
    const double distance = offset.length();
    if (!(distance > 0.0 && distance <= double{std::numeric_limits<float>::max()})) {
        return {Imath::V3f(0.0F), 0.0F, Imath::Color3f(0.0F)};
    }
    const scene::V3d to_light = offset / distance;
    const double meters = distance * meters_per_unit;
    const double cone = lamp.kind == scene::LightKind::spot ? cone_weight(lamp, to_light) : 1.0;
    const double weight = cone * range_weight(lamp, distance) / (meters * meters);
    return {Imath::V3f(to_light), static_cast<float>(distance),
            lamp.intensity * static_cast<float>(weight)};
}

LightBounds bounds_of(const scene::Light& lamp, double meters_per_unit) {
    LightBounds bounds;
    bounds.box.extendBy(Imath::V3f(lamp.position));
    const bool spot = lamp.kind == scene::LightKind::spot;
    bounds.axis = Imath::V3f(lamp.direction);
    bounds.cosine_spread = spot ? std::cos(lamp.inner_cone) : -1.0F;
    bounds.cosine_falloff = spot ? std::cos(lamp.outer_cone - lamp.inner_cone) : 0.0F;
    bounds.power =
        static_cast<float>(double{luminance(lamp.intensity)} / (meters_per_unit * meters_per_unit));
    return bounds;
}

}  // namespace balcony::render
