// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "balcony/lang.hpp"

namespace balcony::cli {

/// An explanation for people.
[[nodiscard]] std::string explanation_text(const lang::Explanation& explanation);
[[nodiscard]] nlohmann::json explanation_json(const lang::Explanation& explanation);

/// What a picture of a size in pixels is computed from: of a picture of one camera its ray, else
/// how much each layer shows, its ray, and the same of frames and leader lines.
[[nodiscard]] std::string formulas_text(const camera::Picture& picture, double width,
                                        double height);

}  // namespace balcony::cli
