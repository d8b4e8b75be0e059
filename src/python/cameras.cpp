// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Cameras and their parameters.

#include <algorithm>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "balcony/drawing.hpp"
#include "balcony/poses.hpp"
#include "balcony/studies.hpp"
#include "python/arrays.hpp"
#include "python/diagnostics.hpp"
#include "python/objects.hpp"
#include "python/running.hpp"
#include "python/words.hpp"

namespace balcony::python {

namespace py = pybind11;

namespace {

using app::EditableCamera;

// What get(camera) makes, while no other thread uses the camera.
template <class Get>
auto locked(const CameraPointer& camera, const Get& get) {
    const py::gil_scoped_release released;
    const std::lock_guard lock(camera->mutex);
    return get(camera->camera);
}

// A text of cameras has a brace or several lines; names and files have none.
CameraPointer make_camera(const std::string& camera, const std::string& name,
                          const std::string& folder) {
    const bool is_text = camera.find_first_of("{\n") != std::string::npos;
    auto made = made_by([&](const std::stop_token& stop) {
        return is_text ? EditableCamera::make(
                             {std::make_shared<const SourceText>("text", camera), folder}, name, {},
                             stop)
               : name.empty() ? EditableCamera::make(camera, {}, stop)
                              : EditableCamera::make(lang::CameraSource(camera), name, {}, stop);
    });
    return std::make_shared<CameraObject>(take(std::move(made)));
}

std::vector<EditableCamera::Parameter> all_parameters(const CameraPointer& camera) {
    return locked(camera, [](EditableCamera& own) { return own.parameters(); });
}

void set_values(const CameraPointer& camera, const py::dict& values) {
    const std::vector<lang::Override> set = values_of(values, all_parameters(camera));
    tell(made_by([&](const std::stop_token& stop) {
        const std::lock_guard lock(camera->mutex);
        ++camera->changes;
        return camera->camera.set(set, stop);
    }));
}

camera::Pose pose_in(const py::object& matrix, const std::string& axes, const std::string& world) {
    const Rows rows = rows_of(matrix, "pose", {4});
    if (rows.count != 3 && rows.count != 4) {
        throw py::value_error("'pose' is no matrix of 3 x 4 or 4 x 4 numbers");
    }
    app::PoseMatrix made{};
    for (std::size_t row = 0; row < 3; ++row) {
        std::copy_n(rows.array.data() + 4 * row, 4, made[row].begin());
    }
    return take(app::pose_of(made, axes, *axes_of(py::str(world))));
}

CameraPointer placed(const CameraPointer& camera, const py::object& matrix, const std::string& axes,
                     const std::string& world) {
    const camera::Pose pose = pose_in(matrix, axes, world);
    return std::make_shared<CameraObject>(locked(camera, [&](EditableCamera& own) {
        EditableCamera made = own.copy();
        made.set_pose(pose);
        return made;
    }));
}

// The rows of its matrix, in a world with z up; None without one.
py::object pose_of(const CameraPointer& camera) {
    const auto pose = locked(camera, [](EditableCamera& own) { return own.pose(); });
    if (!pose) {
        return py::none();
    }
    py::list rows;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& [x, y, z] = pose->rotation[i];
        rows.append(py::make_tuple(x, y, z, pose->position[i]));
    }
    return rows;
}

py::list parameters_of(const CameraPointer& camera) {
    py::list told;
    for (const EditableCamera::Parameter& one : all_parameters(camera)) {
        told.append(py::make_tuple(one.name, one.value, one.written, one.is_angle,
                                   py::make_tuple(one.limits.minimum, one.limits.maximum),
                                   one.limits_text));
    }
    return told;
}

template <class Finding>
py::tuple told_of(const std::string& camera, std::string_view name, const Finding& finding,
                  const std::optional<analyse::V2d>& at) {
    const py::object place = at ? py::object(py::make_tuple(at->x, at->y)) : py::none();
    return py::make_tuple(camera, std::string(name), finding.defect, finding.message,
                          finding.remedy, place);
}

void add_findings(const app::CameraCheck& check, py::list& told) {
    for (const analyse::Finding& one : check.report.findings) {
        told.append(told_of(check.title(), analyse::name_of(one.kind), one, one.place.point));
    }
    if (check.in_scene) {
        for (const auto& one : check.in_scene->findings()) {
            told.append(told_of(check.title(), one.name, one, one.at));
        }
    }
}

py::list check(const CameraPointer& camera, const std::array<std::size_t, 2>& size,
               const ScenePointer& scene) {
    const auto found = take(made_by([&](const std::stop_token& stop) {
        const Locked locked(*camera, scene);
        const auto picture = camera->picture(scene, stop);
        return picture ? scene ? app::check(*picture, scene->scene, size, stop)
                               : app::check(*picture, size, stop)
                       : Result<std::vector<app::CameraCheck>>(picture.diagnostics);
    }));
    py::list told;
    for (const app::CameraCheck& one : found) {
        add_findings(one, told);
    }
    return told;
}

std::string drawing_of(const CameraPointer& camera) {
    return take(made_by([&](const std::stop_token& stop) {
        const std::lock_guard lock(camera->mutex);
        auto drawn =
            analyse::draw(camera->camera.picture(), {}, {.width = 640, .height = 480}, {}, stop);
        return drawn ? Result<std::string>(analyse::to_svg(*drawn))
                     : Result<std::string>(std::move(drawn.diagnostics));
    }));
}

}  // namespace

Locked::Locked(CameraObject& camera, const ScenePointer& scene)
    : scene_(scene ? std::unique_lock(scene->mutex) : std::unique_lock<std::mutex>()),
      camera_(camera.mutex) {}

Result<camera::Picture> CameraObject::picture(const ScenePointer& scene,
                                              const std::stop_token& stop) {
    if (!scene) {
        return camera.picture();
    }
    return placed.get({.scene = scene}, changes,
                      [&] { return camera.picture(scene->scene, stop); });
}

void define_cameras(py::module_& module) {
    py::class_<CameraObject, CameraPointer>(module, "Camera")
        .def(py::init(&make_camera), py::arg("camera"), py::arg("name"), py::arg("folder"))
        .def("copy",
             [](const CameraPointer& camera) {
                 return std::make_shared<CameraObject>(
                     locked(camera, [](EditableCamera& own) { return own.copy(); }));
             })
        .def("placed", &placed)
        .def("pose", &pose_of)
        .def("set", &set_values)
        .def("parameters", &parameters_of)
        .def("name", [](const CameraPointer& camera) { return camera->camera.name(); })
        .def("comment", [](const CameraPointer& camera) { return camera->camera.comment(); })
        .def("text",
             [](const CameraPointer& camera) {
                 return take(locked(camera, [](EditableCamera& own) { return own.text(); }));
             })
        .def("check", &check, py::arg("size"), py::arg("scene"))
        .def("drawing", &drawing_of);
}

}  // namespace balcony::python
