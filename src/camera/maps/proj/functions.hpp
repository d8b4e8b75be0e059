// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// All functions of PROJ that Balcony calls. PROJ brings libraries that take long to load, and few
// cameras are maps.

#include <proj.h>

#include "balcony/base.hpp"

namespace balcony::camera::maps {

/// Made only where PROJ is linked.
struct ProjFunctions {
    decltype(&proj_context_create) context_create = proj_context_create;
    decltype(&proj_context_destroy) context_destroy = proj_context_destroy;
    decltype(&proj_context_errno) context_errno = proj_context_errno;
    decltype(&proj_context_errno_string) context_errno_string = proj_context_errno_string;
    decltype(&proj_create) create = proj_create;
    decltype(&proj_destroy) destroy = proj_destroy;
    decltype(&proj_errno) errno_of = proj_errno;
    decltype(&proj_errno_reset) errno_reset = proj_errno_reset;
    decltype(&proj_list_operations) list_operations = proj_list_operations;
    decltype(&proj_log_level) log_level = proj_log_level;
    decltype(&proj_pj_info) pj_info = proj_pj_info;
    decltype(&proj_trans) trans = proj_trans;
};

/// The functions, or why there are none. Every program has one of two definitions: linked.cpp, or
/// loaded.cpp, which loads a module at the first call.
[[nodiscard]] const Result<const ProjFunctions*>& proj_functions();

}  // namespace balcony::camera::maps
