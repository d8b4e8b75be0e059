// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "balcony/lang.hpp"

namespace balcony::cli {

/// An explanation as text.
[[nodiscard]] std::string explanation_text(const lang::Explanation& explanation);
[[nodiscard]] nlohmann::json explanation_json(const lang::Explanation& explanation);

/// An explanation as text, followed by formulas of a picture of a size in pixels.
[[nodiscard]] std::string explanation_text(const lang::Explanation& explanation,
                                           const std::string& formulas, std::size_t width,
                                           std::size_t height);

/// The formulas of a picture of a size in pixels: the ray of a single camera; otherwise the
/// coverage and the ray of each layer, and the coverages of frames and leader lines.
[[nodiscard]] std::string formulas_text(const camera::Picture& picture, double width,
                                        double height);

}  // namespace balcony::cli
