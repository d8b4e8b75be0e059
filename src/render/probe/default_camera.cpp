// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "balcony/probe.hpp"
#include "render/probe/main_objects.hpp"
#include "render/probe/viewer.hpp"

namespace balcony::render {

namespace {

using Imath::V3d;

using std::numbers::pi;
constexpr double aspect = default_view_aspect;

/// A camera at a point that looks along a direction, for a horizontal field of view.
scene::Camera camera_at(const V3d& position, const V3d& forward, const V3d& up, double field) {
    scene::Camera camera;
    camera.name = "default view";
    camera.position = position;
    camera.forward = forward.normalized();
    camera.right = camera.forward.cross(up).normalized();
    camera.up = camera.right.cross(camera.forward);
    camera.half_height = std::tan(0.5 * field) / aspect;
    camera.aspect = aspect;
    return camera;
}

// From in front of the box and slightly above, as near as shows all of it.
scene::Camera view_of(const Imath::Box3d& box, Axes axes) {
    constexpr double field = 40.0 * pi / 180.0;
    constexpr double margin = 0.92;  // The part of the picture that the box may fill.
    const V3d center = 0.5 * (box.min + box.max);
    // In axes with z up; the front of a scene with y up, its +z, is -y there.
    const V3d offset = turned(V3d(0.5, -1.0, 0.4).normalized(), Axes::z_up, axes);
    scene::Camera camera =
        camera_at(center, -offset, turned(V3d(0.0, 0.0, 1.0), Axes::z_up, axes), field);
    double distance = 0.0;
    for (unsigned i = 0; i < 8; ++i) {
        const auto side = [&](unsigned axis) {
            return ((i >> axis & 1U) != 0 ? box.max : box.min)[static_cast<int>(axis)];
        };
        const V3d corner = V3d(side(0), side(1), side(2)) - center;
        const double reach =
            std::max(std::abs(corner.dot(camera.right)) / aspect, std::abs(corner.dot(camera.up))) /
            (margin * camera.half_height);
        distance = std::max(distance, reach - corner.dot(camera.forward));
    }
    // A scene that consists of a single point is viewed from a small distance.
    camera.position = center + (distance > 0.0 ? distance : 3.0) * offset;
    return camera;
}

/// A place to stand within a closed room.
struct RoomView {
    scene::Camera camera;
    Sight sight;
    bool lit = false;            ///< By a lamp.
    bool faces_inwards = false;  ///< The walls show their front.
};

// The most interesting view from a point.
RoomView best_view_from(const Viewer& viewer, const V3d& point, Axes axes) {
    constexpr double field = 80.0 * pi / 180.0;
    constexpr double downwards = 8.0 * pi / 180.0;
    constexpr int directions = 8;
    RoomView best;
    for (int i = 0; i < directions; ++i) {
        const double yaw = 2.0 * pi * (i + 0.5) / directions;
        const V3d forward(std::cos(yaw), std::sin(yaw), -std::tan(downwards));
        RoomView view;
        view.camera = camera_at(point, turned(forward, Axes::z_up, axes),
                                turned(V3d(0.0, 0.0, 1.0), Axes::z_up, axes), field);
        view.sight = viewer.look(view.camera);
        if (view.sight.interest() > best.sight.interest()) {
            best = std::move(view);
        }
    }
    return best;
}

// From the points of a grid at eye level and below; nothing if none of them is in a closed room.
std::optional<RoomView> best_room_view(const Viewer& viewer, const scene::Scene& scene,
                                       const Imath::Box3d& bounds, const std::stop_token& stop) {
    constexpr double enclosed = 0.97;   // The share of directions in which a closed room has walls.
    constexpr double clearance = 0.02;  // Of the scene's extent.
    constexpr int steps = 5;
    constexpr int least = 5;  // Fewer such places are a niche, not a room.
    int found = 0;
    std::optional<RoomView> best;
    const Imath::Box3d box(turned(bounds.min, scene.axes, Axes::z_up),
                           turned(bounds.max, scene.axes, Axes::z_up));
    const auto between = [](double a, double b, double share) { return a + share * (b - a); };
    for (const double level : {0.35, 0.6}) {
        for (int i = 0; i < steps * steps && !stop.stop_requested(); ++i) {
            const double x = (i % steps + 0.5) / steps;
            const double y = (i / steps + 0.5) / steps;  // NOLINT(bugprone-integer-division)
            const V3d point =
                turned(V3d(between(box.min.x, box.max.x, x), between(box.min.y, box.max.y, y),
                           between(box.min.z, box.max.z, level)),
                       Axes::z_up, scene.axes);
            const Sight round = viewer.look_round(point);
            const bool inwards = 2 * round.fronts > round.hits;
            if (static_cast<double>(round.hits) < enclosed * static_cast<double>(round.rays) ||
                round.nearest < clearance * bounds.size().length() ||
                (!inwards && round.fronts == 0 && !viewer.is_lit(point))) {
                continue;
            }
            ++found;
            RoomView view = best_view_from(viewer, point, scene.axes);
            view.lit = viewer.is_lit(point);
            view.faces_inwards = inwards;
            if (!best || view.sight.interest() > best->sight.interest()) {
                best = std::move(view);
            }
        }
    }
    return found >= least ? best : std::nullopt;
}

// Whether a view of a room tells more about a scene than a view from outside.
bool is_better(const RoomView& room, const Sight& outside, const scene::Scene& scene) {
    const bool shows_more = 2 * room.sight.objects() > 3 * outside.objects();
    return shows_more || room.lit || (room.faces_inwards && scene.lights.empty());
}

}  // namespace

Result<scene::Camera> default_camera(const Renderer& renderer, const std::stop_token& stop) {
    const ProbedScene probed(renderer);
    const scene::Scene& scene = probed.scene();
    const Imath::Box3f bounds = scene.bounds();
    // In double precision, as the sum of two corners may be too large for single.
    const Imath::Box3d whole{V3d(bounds.min), V3d(bounds.max)};
    if (bounds.isEmpty() || !std::isfinite(whole.size().length())) {
        return error("the scene has no finite size, so no camera can show all of it", {},
                     "name a camera with --camera, or correct the coordinates of the scene");
    }
    const Viewer viewer(probed);
    scene::Camera outside = view_of(box_of_main_objects(scene).value_or(whole), scene.axes);
    const std::optional<RoomView> room = best_room_view(viewer, scene, whole, stop);
    if (stop.stop_requested()) {
        return stopped();
    }
    return room && is_better(*room, viewer.look(outside), scene) ? room->camera : outside;
}

}  // namespace balcony::render
