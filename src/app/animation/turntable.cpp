// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/animation/turntable.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "balcony/scene_camera.hpp"

namespace balcony::app {

namespace {

using Imath::V3d;
using std::numbers::pi;

V3d middle_of(const render::SceneExtent& extent) {
    return 0.5 * (extent.bounds.min + extent.bounds.max);
}

// The smallest distance from the middle at which the picture contains the whole profile at every
// angle. A point at radius r and height z, turned by an angle a, is to the right by r sin a, up by
// z cos e - r cos a sin e, and nearer than the middle by r cos a cos e + z sin e.
double distance_for(const render::SceneExtent& extent, double elevation, double half_width,
                    double half_height) {
    constexpr int angles = 72;
    double distance = 0.0;
    for (const Imath::V2d& point : extent.profile) {
        for (int i = 0; i < angles; ++i) {
            const double angle = 2.0 * pi * i / angles;
            const double along = point.x * std::cos(angle);
            const double across = std::abs(point.x * std::sin(angle));
            const double up = std::abs(point.y * std::cos(elevation) - along * std::sin(elevation));
            const double nearer = along * std::cos(elevation) + point.y * std::sin(elevation);
            distance =
                std::max({distance, nearer + across / half_width, nearer + up / half_height});
        }
    }
    // A scene that consists of a single point is viewed from a small distance.
    return distance > 0.0 ? distance : 3.0;
}

}  // namespace

camera::Turn turn_of(const render::SceneExtent& extent, const AnimationRequest& request,
                     const FrameNumbers& frames) {
    // Frames may be left out evenly: 1-240x10.
    const auto count = static_cast<double>(frames.size());
    const auto steps = static_cast<double>(frames.back() - frames.front());
    const double period = request.picture.shutter.rate.frame_time() *
                          (frames.size() > 1 ? steps * count / (count - 1.0) : 1.0);
    auto graph = std::make_shared<expr::Graph>();
    const expr::Expr turns = (graph->time() - request.time_of(frames.front())) / period;
    const V3d middle = middle_of(extent);
    return {camera::Scalar(camera::Formula(graph, {}, {2.0 * pi * turns})),
            {middle.x, middle.y, middle.z},
            Axes::z_up};
}

Result<camera::Picture> turntable_picture(const scene::Scene& scene,
                                          const render::SceneExtent& extent, double aspect) {
    constexpr double field = 30.0 * pi / 180.0;  // Of the shorter side.
    constexpr double elevation = 15.0 * pi / 180.0;
    constexpr double margin = 0.92;  // The part of the picture that the scene may fill.
    const double half = std::tan(0.5 * field);
    const double half_height = aspect < 1.0 ? half / aspect : half;
    const double distance =
        distance_for(extent, elevation, margin * half_height * aspect, margin * half_height);
    const auto in_scene = [&](const V3d& v) { return turned(v, Axes::z_up, scene.axes); };
    // From the front, which is -y with z up.
    const V3d back(0.0, -std::cos(elevation), std::sin(elevation));
    scene::Camera view;
    view.name = "turntable";
    view.position = in_scene(middle_of(extent) + distance * back);
    view.forward = in_scene(-back);
    view.right = in_scene(V3d(1.0, 0.0, 0.0));
    view.up = view.right.cross(view.forward);
    view.half_height = half_height;
    view.aspect = aspect;
    auto made = data::make_camera(view, scene.axes);
    return made ? Result<camera::Picture>(std::move(*made), std::move(made.diagnostics))
                : Result<camera::Picture>(std::move(made.diagnostics));
}

}  // namespace balcony::app
