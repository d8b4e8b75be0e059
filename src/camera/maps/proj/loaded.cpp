// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "base/loaded_module.hpp"
#include "camera/maps/proj/functions.hpp"

namespace balcony::camera::maps {

namespace {

Result<const ProjFunctions*> load() {
    const Result<void*> entry = function_of_module(
        BALCONY_MODULE_FOLDER, BALCONY_MODULE, "balcony_proj_functions", "knows map projections",
        "install the package of PROJ, or build Balcony again for the version that is installed");
    if (!entry) {
        return entry.diagnostics;
    }
    return reinterpret_cast<const ProjFunctions* (*)()>(*entry)();
}

}  // namespace

const Result<const ProjFunctions*>& proj_functions() {
    static const Result<const ProjFunctions*> functions = load();
    return functions;
}

}  // namespace balcony::camera::maps
