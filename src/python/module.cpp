// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The module balcony._balcony. The package around it (python/balcony) has the names, the types and
// the texts that users read.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "balcony/lang.hpp"
#include "balcony/names.hpp"
#include "python/objects.hpp"
#include "python/running.hpp"

PYBIND11_MODULE(_balcony, module) {
    namespace python = balcony::python;
    module.attr("version") = BALCONY_VERSION;
    module.def("stop_all", python::stop_all);
    module.def("suggestion", balcony::suggestion);
    module.def("built_in_cameras", balcony::lang::built_in_cameras);
    module.def("search_cameras", [](const std::string& words) {
        std::vector<std::string> names;
        for (const balcony::lang::CameraMatch& one :
             balcony::lang::search_built_in_cameras(words)) {
            names.push_back(one.name);
        }
        return names;
    });
    python::define_pictures(module);
    python::define_scenes(module);
    python::define_scene_edits(module);
    python::define_cameras(module);
    python::define_rays(module);
    python::define_exports(module);
    python::define_stages(module);
    python::define_studies(module);
    python::define_datasets(module);
}
