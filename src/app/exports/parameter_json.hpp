// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A parameter as the pages in a browser have it (studio/src/protocol.ts).

#include <nlohmann/json_fwd.hpp>

#include "balcony/lang.hpp"

namespace balcony::app {

/// Adds the members that limit a number.
void tell_limits(const camera::Range& limits, nlohmann::json& told);

[[nodiscard]] nlohmann::json told_of(const lang::OpenParameter& parameter);

}  // namespace balcony::app
