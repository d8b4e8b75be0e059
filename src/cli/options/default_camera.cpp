// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/default_camera.hpp"

#include <cmath>
#include <numbers>

#include "balcony/make_stage.hpp"

namespace balcony::cli {

namespace {

using camera::ObjectTransformer;
using camera::radians;

// The stages of the built-in camera `pinhole`. At rest it looks along x.
Result<camera::Picture> pinhole(double half_width, double yaw, double pitch,
                                const Imath::V3d& position) {
    const auto mapper = camera::make_stage<camera::PictureMapper>(
        "square_v", {{"u_first", half_width}, {"u_last", -half_width}});
    const auto eye = camera::make_stage<camera::ObjectGenerator>("point");
    const auto plane =
        camera::make_stage<camera::ObjectGenerator>("plane", {{"at", {1.0, 0.0, 0.0}}});
    const auto look = camera::make_stage<camera::DirectionRule>("relative");
    const auto moves = {
        camera::make_stage<ObjectTransformer>("rotate",
                                              {{"axis", "y"}, {"angle", radians(-pitch)}}),
        camera::make_stage<ObjectTransformer>("rotate", {{"axis", "z"}, {"angle", radians(yaw)}}),
        camera::make_stage<ObjectTransformer>(
            "translate", {{"x", position.x}, {"y", position.y}, {"z", position.z}})};

    Diagnostics found;
    const auto collect = [&found](const auto& made) {
        found.insert(found.end(), made.diagnostics.begin(), made.diagnostics.end());
    };
    collect(mapper);
    std::vector<camera::ObjectTransformerPointer> placed;
    for (const auto& move : moves) {
        collect(move);
        placed.push_back(move.value.value_or(nullptr));
    }
    if (has_errors(found)) {
        return found;
    }
    auto made = camera::Camera::make({.name = "pinhole",
                                      .arrangers = {},
                                      .eye = {*mapper, {}, *eye, placed},
                                      .toward = camera::Path{*mapper, {}, *plane, placed},
                                      .look = *look});
    return made ? Result<camera::Picture>(std::move(*made), std::move(made.diagnostics))
                : Result<camera::Picture>(std::move(made.diagnostics));
}

}  // namespace

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
    return pinhole(std::tan(half_field), yaw, pitch, eye);
}

}  // namespace balcony::cli
