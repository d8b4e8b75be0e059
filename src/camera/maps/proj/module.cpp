// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The module that loaded.cpp loads: one function.

#include "camera/maps/proj/functions.hpp"

extern "C" const balcony::camera::maps::ProjFunctions* balcony_proj_functions() {
    static const balcony::camera::maps::ProjFunctions functions;
    return &functions;
}
