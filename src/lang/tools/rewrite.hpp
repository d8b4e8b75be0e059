// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "balcony/language_service.hpp"
#include "lang/names/session.hpp"

namespace balcony::lang {

/// The changes of a module's text after which a definition that is visible in it has these values,
/// whose names are its parameters.
[[nodiscard]] std::vector<TextEdit> edits_of_values(const Module& module,
                                                    const LocatedDefinition& written,
                                                    const std::vector<Override>& values);

/// A number as literal() has it, but in the digits that a step needs: by how much the smallest
/// movement of a hand changes it.
[[nodiscard]] std::string hand_literal(double value, bool is_angle, double step,
                                       std::string_view instead_of);

/// The text of a module in which a definition that is visible in it has these values, whose names
/// are its parameters.
[[nodiscard]] std::string rewritten(const Module& module, const LocatedDefinition& written,
                                    const std::vector<Override>& values);

}  // namespace balcony::lang
