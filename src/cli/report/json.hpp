// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "balcony/base.hpp"

namespace balcony::cli {

/// Diagnostics as a list of objects: severity, kind of errors, message, remedy, file, line, column.
[[nodiscard]] nlohmann::json to_json(const Diagnostics& diagnostics);

}  // namespace balcony::cli
