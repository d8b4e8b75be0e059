// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "balcony/language_service.hpp"

namespace balcony::studio {

/// Edits that make one text of another, in its order: one in each line that differs if both have as
/// many lines, otherwise a single one.
[[nodiscard]] std::vector<lang::TextEdit> edits_between(std::string_view before,
                                                        std::string_view after);

}  // namespace balcony::studio
