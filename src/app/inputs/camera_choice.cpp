// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/inputs.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/scene_camera.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view scene_prefix = "scene:";

CameraArgument split_camera(const std::string& text) {
    const auto colon = text.rfind(':');
    std::error_code ignored;
    const bool is_address = text.find("://") != std::string::npos;
    if (colon == std::string::npos || is_address || fs::exists(text, ignored)) {
        return {text, "", {}};
    }
    return {text.substr(0, colon), text.substr(colon + 1), {}};
}

Diagnostic unknown_camera(const std::string& name, const scene::Scene& scene) {
    if (scene.cameras.empty()) {
        return error(fmt::format("'{}' has no cameras", scene.name), {},
                     "export the scene with its cameras, or name a camera file");
    }
    std::vector<std::string> names;
    for (const scene::Camera& camera : scene.cameras) {
        names.push_back(camera.name);
    }
    const auto nearest = nearest_name(name, names);
    return error(fmt::format("'{}' has no camera '{}'", scene.name, name), {},
                 nearest ? fmt::format("did you mean '{}{}'?", scene_prefix, *nearest)
                         : fmt::format("its cameras are {}", fmt::join(names, ", ")));
}

}  // namespace

bool is_of_scene(const std::string& camera) {
    std::error_code ignored;
    return camera.starts_with(scene_prefix) && !fs::exists(camera, ignored);
}

Result<const scene::Camera*> camera_of(const scene::Scene& scene, const std::string& camera) {
    const std::string name = camera.substr(scene_prefix.size());
    const auto found = std::find_if(
        scene.cameras.begin(), scene.cameras.end(),
        [&name](const scene::Camera& one) { return name.empty() || one.name == name; });
    if (found == scene.cameras.end()) {
        return unknown_camera(name, scene);
    }
    return &*found;
}

fs::path camera_file(const std::string& camera) {
    return is_of_scene(camera) ? fs::path() : split_camera(camera).file;
}

Result<CameraArgument> read_camera(const std::string& camera, const std::vector<std::string>& set) {
    if (is_of_scene(camera)) {
        return error(fmt::format("'{}' is a camera of a scene, but no scene is given", camera), {},
                     "such cameras are for balcony render, and for balcony locate with --scene");
    }
    CameraArgument wanted = split_camera(camera);
    for (const std::string& text : set) {
        const auto equals = text.find('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
            return error(fmt::format("--set {} sets nothing", text), {},
                         "write --set name=value, such as --set gamma=1/2");
        }
        wanted.overrides.push_back({text.substr(0, equals), text.substr(equals + 1)});
    }
    if (wanted.name.empty() && camera.ends_with(':')) {
        return error(fmt::format("'{}' names no camera after the colon", camera), {},
                     fmt::format("write {}:NAME, or {} for its last camera", wanted.file.string(),
                                 wanted.file.string()));
    }
    return wanted;
}

Result<camera::Picture> load_picture(const std::string& picture,
                                     const std::vector<std::string>& set,
                                     const std::stop_token& stop) {
    lang::Workspace workspace;
    workspace.stop_with(stop);
    return load_picture(picture, set, workspace);
}

Result<camera::Picture> load_picture(const std::string& picture,
                                     const std::vector<std::string>& set,
                                     lang::Workspace& workspace) {
    const Result<CameraArgument> wanted = read_camera(picture, set);
    return wanted ? workspace.make_picture(wanted->file, wanted->name, wanted->overrides)
                  : Result<camera::Picture>(wanted.diagnostics);
}

Result<camera::Picture> load_picture(const std::string& picture,
                                     const std::vector<std::string>& set, const scene::Scene& scene,
                                     const std::stop_token& stop) {
    if (!is_of_scene(picture)) {
        return load_picture(picture, set, stop);
    }
    if (!set.empty()) {
        return error(fmt::format("'{}' has no parameters that --set could set", picture), {},
                     "--set is for cameras of camera files");
    }
    const Result<const scene::Camera*> found = camera_of(scene, picture);
    if (!found) {
        return found.diagnostics;
    }
    return picture_of(**found, scene.axes);
}

Result<camera::Picture> picture_of(const scene::Camera& camera, Axes axes) {
    auto made = data::make_camera(camera, axes);
    return made ? Result<camera::Picture>(std::move(*made), std::move(made.diagnostics))
                : Result<camera::Picture>(std::move(made.diagnostics));
}

Result<camera::Picture> default_picture(const scene::Scene& scene, const render::Renderer& renderer,
                                        const std::stop_token& stop) {
    if (!scene.cameras.empty()) {
        return picture_of(scene.cameras.front(), scene.axes);
    }
    const Result<scene::Camera> view = render::default_camera(renderer, stop);
    return view ? picture_of(*view, scene.axes) : Result<camera::Picture>(view.diagnostics);
}

}  // namespace balcony::app
