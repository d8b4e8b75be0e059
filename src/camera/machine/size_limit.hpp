// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "balcony/base.hpp"

namespace balcony::camera {

/// The error of a camera or a picture with more operations than it may have, as repetitions of
/// repetitions make them.
[[nodiscard]] inline Diagnostic too_large(std::string_view what, const std::string& name,
                                          std::size_t maximum) {
    return error(fmt::format("{} '{}' is too large: its formulas have more than {} operations",
                             what, name, maximum),
                 {}, "repeat fewer stages");
}

}  // namespace balcony::camera
