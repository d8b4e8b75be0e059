// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/maps/proj/functions.hpp"

namespace balcony::camera::maps {

const Result<const ProjFunctions*>& proj_functions() {
    static const ProjFunctions functions;
    static const Result<const ProjFunctions*> result = &functions;
    return result;
}

}  // namespace balcony::camera::maps
