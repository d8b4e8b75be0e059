// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What objects of Python hold. Work on other threads holds what it uses, and locks it.

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include <pybind11/pybind11.h>

#include "balcony/editable_camera.hpp"
#include "balcony/film.hpp"
#include "balcony/inverse.hpp"
#include "balcony/prepared_scene.hpp"
#include "balcony/ray_maps.hpp"

namespace balcony::python {

struct SceneObject {
    SceneObject(app::PreparedScene made, app::Request with)
        : axes(made.scene()->axes), scene(std::move(made)), request(std::move(with)) {}

    /// What get(scene) makes, while no other thread uses the scene. With the lock of Python, which
    /// is released meanwhile.
    template <class Get>
    [[nodiscard]] auto locked(const Get& get) {
        const pybind11::gil_scoped_release released;
        const std::lock_guard lock(mutex);
        return get(std::as_const(scene));
    }

    std::mutex mutex;
    const Axes axes;
    app::PreparedScene scene;
    const app::Request request;  // By which it was loaded.
    std::size_t changes = 0;     // Of the scene, since it was loaded.
};
using ScenePointer = std::shared_ptr<SceneObject>;

/// What is asked about the picture of a camera.
struct PictureQuery {
    bridge::RaySettings rays{};  // By default in the axes of the scene, if there is one.
    ScenePointer scene{};        // Null for a camera by itself.

    [[nodiscard]] double width() const { return static_cast<double>(rays.width); }
    [[nodiscard]] double height() const { return static_cast<double>(rays.height); }
};

/// The last thing that was made for a query, while nothing else has changed. It does not keep the
/// scene.
template <class Made>
class Last {
public:
    template <class Make>
    [[nodiscard]] Result<Made> get(const PictureQuery& query, std::size_t changes,
                                   const Make& make) {
        const std::array versions{changes, query.scene ? query.scene->changes : 0};
        const bool is_same = query.rays == rays_ && versions == versions_ &&
                             has_scene_ == (query.scene != nullptr) && scene_.lock() == query.scene;
        if (made_ && is_same) {
            return *made_;
        }
        Result<Made> made = make();
        if (made) {
            made_ = *made;
            rays_ = query.rays;
            versions_ = versions;
            has_scene_ = query.scene != nullptr;
            scene_ = query.scene;
        }
        return made;
    }

private:
    std::optional<Made> made_{};
    bridge::RaySettings rays_{};
    std::array<std::size_t, 2> versions_{};  // Of the camera and the scene.
    bool has_scene_ = false;
    std::weak_ptr<SceneObject> scene_{};
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

/// A rendered picture, and how a display shows it.
struct PictureObject {
    std::shared_ptr<const render::Film> film;
    std::string camera;  // Its name.
    render::DisplayOptions display{};
};

/// A query in words of Python. Raises ValueError.
[[nodiscard]] PictureQuery query_of(const std::array<std::size_t, 2>& size,
                                    const std::string& layer, const pybind11::object& axes,
                                    double time, const ScenePointer& scene);
/// The rays of a query. Locks the camera and the scene.
[[nodiscard]] Result<bridge::RayGrid> grid_of(CameraObject& camera, const PictureQuery& query,
                                              const std::stop_token& stop);

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
void define_exports(pybind11::module_& module);
void define_scenes(pybind11::module_& module);
void define_scene_edits(pybind11::module_& module);
void define_pictures(pybind11::module_& module);
void define_stages(pybind11::module_& module);
void define_studies(pybind11::module_& module);
void define_datasets(pybind11::module_& module);

}  // namespace balcony::python
