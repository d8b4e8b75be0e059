// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "balcony/prescription.hpp"

namespace balcony::cli {

/// A table of its optics near the axis and of its spots.
[[nodiscard]] std::string to_text(const camera::Prescription& lens,
                                  const std::vector<camera::FieldSpots>& fields);
[[nodiscard]] nlohmann::json to_json(const camera::Prescription& lens,
                                     const std::vector<camera::FieldSpots>& fields);

}  // namespace balcony::cli
