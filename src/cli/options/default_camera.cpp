// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/default_camera.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "balcony/lang.hpp"

namespace balcony::cli {

Result<camera::Picture> default_picture(const scene::Scene& scene) {
    // In the camera's axes: z up; the front of a y-up scene, its +z, is the camera's -y.
    // In double precision, as the sum of two corners may be too large for single.
    const auto bounds = scene.bounds();
    const Imath::V3d minimum(bounds.min);
    const Imath::V3d maximum(bounds.max);
    const Imath::V3d size = maximum - minimum;
    if (bounds.isEmpty() || !std::isfinite(size.length())) {
        return error("the scene has no finite size, so no camera can show all of it", {},
                     "name a camera with --camera, or correct the coordinates of the scene");
    }
    const Imath::V3d middle = 0.5 * (minimum + maximum);
    const Imath::V3d center = turned(middle, scene.axes, Axes::z_up);
    // A scene that consists of a single point is viewed from a small distance.
    const double extent = size.length();
    const double radius = extent > 0.0 ? 0.5 * extent : 1.0;

    constexpr double half_field = 20.0 * std::numbers::pi / 180.0;
    constexpr double vertical_share = 9.0 / 16.0;
    const double distance = radius / std::sin(std::atan(std::tan(half_field) * vertical_share));
    const Imath::V3d offset = Imath::V3d(0.5, -1.0, 0.4).normalized() * distance;
    const Imath::V3d eye = center + offset;
    const double yaw = std::atan2(-offset.y, -offset.x);
    const double pitch = std::asin(-offset.z / distance);
    const auto number = [](double value) { return fmt::format("{}", value); };
    const auto angle = [](double value) { return fmt::format("{}rad", value); };
    return lang::load_picture("pinhole", "pinhole",
                              {{"fov", angle(2.0 * half_field)},
                               {"px", number(eye.x)},
                               {"py", number(eye.y)},
                               {"pz", number(eye.z)},
                               {"yaw", angle(yaw)},
                               {"pitch", angle(pitch)}});
}

}  // namespace balcony::cli
