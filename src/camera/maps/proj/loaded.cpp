// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "base/loaded_module.hpp"
#include "camera/maps/proj/functions.hpp"

namespace balcony::camera::maps {

const Result<const ProjFunctions*>& proj_functions() {
    static const auto functions = loaded_from_module<ProjFunctions>(
        BALCONY_MODULE_FOLDER, BALCONY_MODULE, "balcony_proj_functions", "knows map projections",
        "PROJ");
    return functions;
}

}  // namespace balcony::camera::maps
