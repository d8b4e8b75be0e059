// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Scenes, and pictures of them.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "balcony/inputs.hpp"
#include "balcony/picture_options.hpp"
#include "balcony/prepared_scene.hpp"
#include "python/diagnostics.hpp"
#include "python/objects.hpp"
#include "python/running.hpp"
#include "python/told.hpp"
#include "python/words.hpp"

namespace balcony::python {

namespace py = pybind11;

namespace {

ScenePointer load(const std::string& file, const py::dict& options) {
    app::Request request;
    read_options(options, OptionUse::scene, request);
    request.scene = file;
    auto made = take(made_by(
        [&](const std::stop_token& stop) { return app::PreparedScene::make(request, {}, stop); }));
    return std::make_shared<SceneObject>(std::move(made), std::move(request));
}

ScenePointer empty_scene(const py::object& axes, const py::dict& options) {
    app::Request request;
    read_options(options, OptionUse::scene, request);
    scene::Scene scene;
    scene.axes = *axes_of(axes);
    scene.default_light = true;
    auto made = take(made_by([&](const std::stop_token& stop) {
        return app::PreparedScene::make(scene, request, {}, stop);
    }));
    return std::make_shared<SceneObject>(std::move(made), std::move(request));
}

ScenePointer copy(const ScenePointer& scene) {
    return std::make_shared<SceneObject>(
        scene->locked([](const app::PreparedScene& own) { return own.share(); }), scene->request);
}

app::Observer observer_of(ToldPart& told) {
    app::Observer made;
    made.progress = [&told](const render::Progress& progress) {
        told.set(static_cast<double>(progress.tiles_done) / static_cast<double>(progress.tiles));
    };
    return made;
}

struct Rendered {
    app::Report report;
    std::shared_ptr<const render::Film> film;
};

// The camera of a picture: one of a file, or one of the scene.
Result<camera::Picture> picture_in(const ScenePointer& scene, const CameraPointer& camera,
                                   const std::string& name, const std::stop_token& stop) {
    if (camera) {
        const std::lock_guard lock(camera->mutex);
        return camera->picture(scene, stop);
    }
    app::PreparedScene& own = scene->scene;
    Diagnostics found = own.prepare({}, stop);
    if (has_errors(found)) {
        return found;
    }
    return name.empty() ? app::default_picture(*own.scene(), own.renderer(), stop)
                        : app::load_picture(name, {}, *own.scene(), stop);
}

Rendered rendered(const ScenePointer& scene, const CameraPointer& camera,
                  const app::Request& request, const app::Observer& observer,
                  const std::stop_token& stop) {
    const std::lock_guard lock(scene->mutex);
    Rendered made;
    const auto picture = picture_in(scene, camera, request.camera, stop);
    made.report.diagnostics = picture.diagnostics;
    if (picture) {
        made.report = scene->scene.render(*picture, request, observer, stop);
        made.report.diagnostics.insert(made.report.diagnostics.begin(), picture.diagnostics.begin(),
                                       picture.diagnostics.end());
        made.film = scene->scene.film();
    }
    return made;
}

// `of_scene` is a camera of the scene, scene:NAME, that shows it without another one.
PictureObject render(const ScenePointer& scene, const CameraPointer& camera,
                     const py::dict& options, const std::string& of_scene,
                     const py::object& progress) {
    app::Request request = scene->request;
    request.camera = of_scene;
    read_options(options, OptionUse::picture, request);
    ToldPart told(progress);
    const app::Observer observer = observer_of(told);
    Rendered made = made_by(
        [&](const std::stop_token& stop) {
            return rendered(scene, camera, request, observer, stop);
        },
        [&] { told(); });
    tell(made.report.diagnostics);
    render::DisplayOptions display = request.display();
    if (!request.exposure) {
        display.exposure = balcony::render::automatic_exposure(*made.film);
    }
    return {std::move(made.film), std::move(made.report.camera), display};
}

void set_time(const ScenePointer& scene, double time) {
    tell(made_by([&](const std::stop_token&) {
        const std::lock_guard lock(scene->mutex);
        ++scene->changes;
        return scene->scene.set_time(time);
    }));
}

template <class Things>
std::vector<std::string> names_of(const Things& things) {
    std::vector<std::string> names;
    for (const auto& one : things) {
        names.push_back(one.name);
    }
    return names;
}

}  // namespace

void define_scenes(py::module_& module) {
    py::class_<SceneObject, ScenePointer>(module, "Scene")
        .def(py::init(&load), py::arg("file"), py::arg("options"))
        .def_static("empty", &empty_scene, py::arg("axes"), py::arg("options"))
        .def(
            "objects",
            [](SceneObject& scene) {
                return scene.locked([](const auto& own) { return names_of(own.scene()->objects); });
            })
        .def(
            "cameras",
            [](SceneObject& scene) {
                return scene.locked([](const auto& own) { return names_of(own.scene()->cameras); });
            })
        .def("materials",
             [](SceneObject& scene) {
                 return scene.locked(
                     [](const auto& own) { return names_of(own.scene()->materials); });
             })
        .def("lights",
             [](SceneObject& scene) {
                 return scene.locked([](const auto& own) { return names_of(own.scene()->lights); });
             })
        .def("copy", &copy)
        .def("axes",
             [](const SceneObject& scene) { return scene.axes == Axes::y_up ? "y_up" : "z_up"; })
        .def("time",
             [](SceneObject& scene) {
                 return scene.locked([](const auto& own) { return own.settings().time; });
             })
        .def("set_time", &set_time)
        .def("render", &render, py::arg("camera"), py::arg("options"), py::arg("of_scene"),
             py::arg("progress"));
}

}  // namespace balcony::python
