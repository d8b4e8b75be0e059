// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lang/reporter.hpp"
#include "lang/syntax/syntax.hpp"

namespace balcony::lang {

/// Parses a camera file. Parts with errors are reported, and omitted or marked in the tree.
[[nodiscard]] SyntaxTree parse(std::shared_ptr<const SourceText> source, Reporter& reporter);

/// Parses `name = expression`, the value of --set. The expression is the tree's last; there is none
/// if there were errors.
[[nodiscard]] SyntaxTree parse_override(std::shared_ptr<const SourceText> source,
                                        Reporter& reporter);

}  // namespace balcony::lang
