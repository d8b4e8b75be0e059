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
        if (auto fault = place(camera, world_from_node)) {
            throw PartError{std::move(*fault)};
        }
        scene_.cameras.push_back(std::move(camera));
    } catch (const PartError& fault) {
        import_.warn(fmt::format("camera {} is skipped: {}", in_quotes(camera.name), fault.reason));
    }
}

}  // namespace balcony::scene
