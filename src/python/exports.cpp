// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Cameras for other programs, and cameras from what they are to show.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "balcony/camera_export.hpp"
#include "balcony/names.hpp"
#include "balcony/solving.hpp"
#include "python/diagnostics.hpp"
#include "python/objects.hpp"
#include "python/running.hpp"
#include "python/words.hpp"

namespace balcony::python {

namespace py = pybind11;

namespace {

const bridge::ExportTarget& target_of(const std::string& name) {
    const bridge::ExportTarget* const found = bridge::find_export_target(name);
    if (found == nullptr) {
        std::vector<std::string> names;
        for (const bridge::ExportTarget& one : bridge::export_targets()) {
            names.emplace_back(one.name);
        }
        tell({error(Kind::usage, "there is no language '" + name + "'",
                    suggestion(name, names, "the languages are"))});
    }
    return *found;
}

std::string text_in(const CameraPointer& camera, const std::string& language, bool inverse,
                    bool single, const py::object& axes, const std::array<std::size_t, 2>& size) {
    const app::CameraExportRequest request{.target = &target_of(language),
                                           .single = single,
                                           .inverse = inverse,
                                           .axes = axes_of(axes),
                                           .size = size};
    return take(made_by([&](const std::stop_token&) {
               const std::lock_guard lock(camera->mutex);
               return camera->camera.export_camera(request);
           }))
        .text;
}

void save_rays(const CameraPointer& camera, const std::string& file,
               const std::array<std::size_t, 2>& size, const std::string& layer,
               const py::object& axes, double time, const ScenePointer& scene, bool footprints) {
    PictureQuery query = query_of(size, layer, axes, time, scene);
    query.rays.footprints = footprints;
    tell(made_by([&](const std::stop_token& stop) {
        const auto grid = grid_of(*camera, query, stop);
        if (!grid) {
            return grid.diagnostics;
        }
        Diagnostics found = grid.diagnostics;
        auto written =
            bridge::write_ray_map(*grid, file, bridge::NumberFormat::single_precision, stop);
        found.insert(found.end(), written.problems.begin(), written.problems.end());
        return found;
    }));
}

// Name, value and deviation of the parameters, and the text of the new file.
py::tuple solved(const std::string& camera, const std::string& marks,
                 const std::vector<std::string>& set, std::size_t starts) {
    const app::SolveRequest request{.camera = camera, .set = set, .marks = marks, .starts = starts};
    const auto report = take(
        made_by([&](const std::stop_token& stop) { return app::solve_camera(request, stop); }));
    py::list told;
    for (const app::SolvedParameter& one : report.parameters) {
        told.append(py::make_tuple(one.name, one.value, one.deviation));
    }
    return py::make_tuple(report.text, report.camera, told, app::position_error(report));
}

}  // namespace

void define_exports(py::module_& module) {
    module.def("export_languages", [] {
        py::list told;
        for (const bridge::ExportTarget& one : bridge::export_targets()) {
            told.append(py::make_tuple(std::string(one.name), std::string(one.meaning)));
        }
        return told;
    });
    module.def("export_camera", &text_in);
    module.def("save_rays", &save_rays);
    module.def("solve", &solved);
}

}  // namespace balcony::python
