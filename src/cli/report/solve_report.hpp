// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "balcony/solving.hpp"

namespace balcony::cli {

/// Tables of the parameters, of what the constraints miss, and of the uncertainty.
[[nodiscard]] std::string to_text(const app::SolveReport& report);

/// Angles are in radians; what is not determined or not seen is null.
[[nodiscard]] nlohmann::json to_json(const app::SolveReport& report);

}  // namespace balcony::cli
