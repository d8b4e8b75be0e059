// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/scene_camera.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "balcony/make_stage.hpp"

namespace balcony::data {

namespace {

using camera::ObjectGenerator;
using scene::V3d;

// A rectangle in front of the camera, by multiples of right and up.
Result<camera::ObjectGeneratorPointer> plane(const V3d& at, const V3d& along_u,
                                             const V3d& along_v) {
    return camera::make_stage<ObjectGenerator>("plane",
                                               {{"at", {at.x, at.y, at.z}},
                                                {"along_u", {along_u.x, along_u.y, along_u.z}},
                                                {"along_v", {along_v.x, along_v.y, along_v.z}}});
}

// The part of the plane at a distance that the picture shows.
Result<camera::ObjectGeneratorPointer> picture_plane(const scene::Camera& camera, double distance) {
    const V3d at = camera.position + distance * camera.forward;
    const bool is_perspective = camera.projection == scene::Projection::perspective;
    const double scale = is_perspective ? distance : 1.0;
    return scale > 0.0 ? plane(at, scale * camera.right, scale * camera.up)
                       : camera::make_stage<ObjectGenerator>(
                             "point", {{"x", at.x}, {"y", at.y}, {"z", at.z}});
}

}  // namespace

Result<camera::Camera> make_camera(const scene::Camera& camera, Axes axes) {
    const auto mapper = camera::make_stage<camera::PictureMapper>(
        "square_u", {{"v_first", -camera.half_height}, {"v_last", camera.half_height}});
    // The second plane is so far from the first that their difference is exact enough.
    const auto eye = picture_plane(camera, camera.near);
    const auto toward = picture_plane(camera, std::max(2.0 * camera.near, 1.0));
    const auto look = camera::make_stage<camera::DirectionRule>("relative");

    Diagnostics found;
    const auto collect = [&found](const auto& made) {
        found.insert(found.end(), made.diagnostics.begin(), made.diagnostics.end());
    };
    collect(mapper);
    collect(eye);
    collect(toward);
    collect(look);
    if (has_errors(found)) {
        return found;
    }
    const std::array sides{2.0 * camera.half_height * camera.aspect, 2.0 * camera.half_height};
    const bool has_scale = camera.projection == scene::Projection::orthographic;
    return camera::Camera::make({.name = camera.name,
                                 .arrangers = {},
                                 .eye = {*mapper, {}, *eye, {}},
                                 .toward = camera::Path{*mapper, {}, *toward, {}},
                                 .look = *look,
                                 .aspect = camera.aspect,
                                 .sides = has_scale ? std::optional(sides) : std::nullopt,
                                 .axes = axes});
}

}  // namespace balcony::data
