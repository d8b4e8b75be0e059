// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lang/reporter.hpp"
#include "lang/syntax/syntax.hpp"

namespace balcony::lang {

/// Reads a camera file. What has errors is reported and left out or marked; the rest is there.
[[nodiscard]] SyntaxTree parse(std::shared_ptr<const SourceText> source, Reporter& reporter);

/// Reads `name = expression`, as given to --set. The expression is the tree's last; there is none
/// if there were errors.
[[nodiscard]] SyntaxTree parse_override(std::shared_ptr<const SourceText> source,
                                        Reporter& reporter);

}  // namespace balcony::lang
