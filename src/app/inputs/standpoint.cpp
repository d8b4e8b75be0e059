// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/inputs/standpoint.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "balcony/inputs.hpp"

namespace balcony::app {

namespace {

using Imath::V3d;
using Look = lang::SceneMeasures::Look;
using std::numbers::pi;

// Without roll, along a direction in axes with z up.
Look look_along(const V3d& direction) {
    return {.yaw = std::atan2(direction.y, direction.x),
            .pitch = std::atan2(direction.z, std::hypot(direction.x, direction.y))};
}

Look look_of(const scene::Camera& camera, Axes axes) {
    const V3d forward = turned(camera.forward, axes, Axes::z_up);
    const V3d right = turned(camera.right, axes, Axes::z_up);
    Look look = look_along(forward);
    const V3d level(std::sin(look.yaw), -std::cos(look.yaw), 0.0);
    look.roll = std::atan2(-right.dot(level.cross(forward)), right.dot(level));
    return look;
}

}  // namespace

Result<Standpoint> standpoint(const Placement& placement, const scene::Scene& scene,
                              const render::SceneExtent& extent) {
    Standpoint made{.position = extent.inside, .angle = 2.0 * pi};
    const auto* const place = placement.from ? &*placement.from : nullptr;
    if (const auto* const name = std::get_if<std::string>(place)) {
        const Result<const scene::Camera*> camera = camera_of(scene, *name);
        if (!camera) {
            return camera.diagnostics;
        }
        made.position = turned((*camera)->position, scene.axes, Axes::z_up);
        made.look = look_of(**camera, scene.axes);
    } else if (const auto* const point = std::get_if<V3d>(place)) {
        made.position = turned(*point, scene.axes, Axes::z_up);
    }
    if (!placement.fit_to.empty()) {
        const V3d way = 0.5 * (extent.bounds.min + extent.bounds.max) - made.position;
        const double radius = 0.5 * extent.bounds.size().length();
        if (way.length() > radius) {
            made.look = look_along(way);
            made.angle = 2.0 * std::asin(radius / way.length());
        }
    }
    return made;
}

}  // namespace balcony::app
