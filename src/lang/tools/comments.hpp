// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "lang/syntax/syntax.hpp"

namespace balcony::lang {

/// The comments directly above an offset, separated by a line break only, without their marks.
[[nodiscard]] std::string comment_above(const SyntaxTree& tree, std::size_t offset);

}  // namespace balcony::lang
