// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "balcony/base.hpp"

namespace balcony::rays {

/// What `make()` makes, or an error if it writes more operations than a graph holds.
template <class Made, class Make>
[[nodiscard]] Result<Made> within_limits(std::string_view what, const std::string& name,
                                         const Make& make) {
    try {
        return make();
    } catch (const std::length_error&) {
        return error(fmt::format("{} '{}' is too large: its formulas and their derivatives have "
                                 "more operations than a graph holds",
                                 what, name),
                     {}, "repeat fewer stages, or take simpler ones");
    }
}

}  // namespace balcony::rays
