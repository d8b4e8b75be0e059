// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "lang/names/session.hpp"

namespace balcony::lang {

/// The text of a module in which a definition that is visible in it has these values, whose names
/// are its parameters.
[[nodiscard]] std::string rewritten(const Module& module, const LocatedDefinition& written,
                                    const std::vector<Override>& values);

}  // namespace balcony::lang
