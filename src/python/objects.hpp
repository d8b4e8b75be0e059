// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What objects of Python hold. Work on other threads holds what it uses, and locks it.

#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include <pybind11/pybind11.h>

#include "balcony/editable_camera.hpp"
#include "balcony/inverse.hpp"
#include "balcony/prepared_scene.hpp"
#include "balcony/ray_maps.hpp"

namespace balcony::python {

struct SceneObject {
    explicit SceneObject(app::PreparedScene made) : scene(std::move(made)) {}

    std::mutex mutex;
    app::PreparedScene scene;
    std::size_t changes = 0;  // Of the scene, since it was loaded.
};
using ScenePointer = std::shared_ptr<SceneObject>;

/// What is asked about the picture of a camera.
struct PictureQuery {
    std::size_t width = 0;  // In pixels.
    std::size_t height = 0;
    std::string layer{};         // As RaySettings::layer.
    std::optional<Axes> axes{};  // By default those of the scene or, without one, of the camera.
    double time = 0.0;
    bool footprints = false;
    ScenePointer scene{};  // Null for a camera by itself.

    bool operator==(const PictureQuery&) const = default;
};

/// The last thing that was made for a query, while nothing else has changed.
template <class Made>
class Last {
public:
    template <class Make>
    [[nodiscard]] Result<Made> get(const PictureQuery& query, std::size_t changes,
                                   const Make& make) {
        const std::size_t of_scene = query.scene ? query.scene->changes : 0;
        if (made_ && query == query_ && changes == changes_ && of_scene == of_scene_) {
            return *made_;
        }
        Result<Made> made = make();
        if (made) {
            made_ = *made;
            query_ = query;
            changes_ = changes;
            of_scene_ = of_scene;
        }
        return made;
    }

private:
    std::optional<Made> made_{};
    PictureQuery query_{};
    std::size_t changes_ = 0;
    std::size_t of_scene_ = 0;
};

struct CameraObject {
    explicit CameraObject(app::EditableCamera made) : camera(std::move(made)) {}

    std::mutex mutex;
    app::EditableCamera camera;
    std::size_t changes = 0;
    Last<camera::Picture> placed{};
    Last<bridge::RayGrid> grid{};
    Last<analyse::Locator> locator{};

    /// The picture, in the scene if there is one. Both are locked.
    [[nodiscard]] Result<camera::Picture> picture(const ScenePointer& scene,
                                                  const std::stop_token& stop);
};
using CameraPointer = std::shared_ptr<CameraObject>;

/// Locks a camera and, if there is one, a scene.
class Locked {
public:
    Locked(CameraObject& camera, const ScenePointer& scene);

private:
    std::unique_lock<std::mutex> scene_;
    std::unique_lock<std::mutex> camera_;
};

void define_cameras(pybind11::module_& module);
void define_rays(pybind11::module_& module);
void define_scenes(pybind11::module_& module);
void define_films(pybind11::module_& module);

}  // namespace balcony::python
