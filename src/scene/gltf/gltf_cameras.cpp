// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "scene/gltf/gltf_reader.hpp"

namespace balcony::scene {

namespace {

// A size that a camera must have.
double positive_in(const Json& json, const char* key) {
    const double number = number_in(json, key, 0.0);
    if (!(number > 0.0 && number <= max_coordinate)) {
        throw PartError{fmt::format("its '{}' is not a positive number", key)};
    }
    return number;
}

// glTF 2.0, section 3.10.3. Without an aspect ratio, that of the picture applies; Camera's default
// stands for it.
void read_perspective(const Json& json, Camera& camera) {
    const double angle = positive_in(json, "yfov");
    if (angle >= std::numbers::pi) {
        throw PartError{"its 'yfov' is not below 180 degrees"};
    }
    camera.projection = Projection::perspective;
    camera.half_height = std::tan(0.5 * angle);
    if (!member(json, "aspectRatio").is_null()) {
        camera.aspect = positive_in(json, "aspectRatio");
    }
}

void read_orthographic(const Json& json, Camera& camera) {
    camera.projection = Projection::orthographic;
    camera.half_height = positive_in(json, "ymag");
    camera.aspect = positive_in(json, "xmag") / camera.half_height;
}

// The camera looks along its node's -z, with +y up. It ignores the node's scale.
void place(Camera& camera, const M44d& world_from_node) {
    const auto turned = [&](const V3d& axis) {
        V3d direction;
        world_from_node.multDirMatrix(axis, direction);
        return direction;
    };
    camera.position = V3d(0.0) * world_from_node;
    camera.forward = turned(V3d(0.0, 0.0, -1.0)).normalized();
    const V3d up = turned(V3d(0.0, 1.0, 0.0));
    camera.up = (up - up.dot(camera.forward) * camera.forward).normalized();
    camera.right = camera.forward.cross(camera.up);
    if (!(camera.right.length() > 0.5)) {
        throw PartError{"its node's transform gives it no direction"};
    }
    if (world_from_node.determinant() < 0.0) {
        camera.right = -camera.right;
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(camera.position[axis]) <= max_coordinate)) {
            throw PartError{fmt::format("it is further than {:g} from the origin", max_coordinate)};
        }
    }
}

}  // namespace

void GltfReader::place_camera(const Json& node, const M44d& world_from_node) {
    if (member(node, "camera").is_null()) {
        return;
    }
    Camera camera;
    camera.name = text_in(node, "name");
    try {
        const Json& json = element(root_, "cameras", count_in(node, "camera", 0));
        if (camera.name.empty()) {
            camera.name =
                text_in(json, "name", fmt::format("camera {}", scene_.cameras.size() + 1));
        }
        const std::string type = text_in(json, "type");
        if (type != "perspective" && type != "orthographic") {
            throw PartError{fmt::format("its type {} is unknown", in_quotes(type))};
        }
        const Json& projection = member(json, type);
        type == "perspective" ? read_perspective(projection, camera)
                              : read_orthographic(projection, camera);
        const double near = number_in(projection, "znear", 0.0);
        camera.near = std::isfinite(near) ? std::clamp(near, 0.0, max_coordinate) : 0.0;
        place(camera, world_from_node);
        scene_.cameras.push_back(std::move(camera));
    } catch (const PartError& fault) {
        import_.warn(fmt::format("camera {} is skipped: {}", in_quotes(camera.name), fault.reason));
    }
}

}  // namespace balcony::scene
