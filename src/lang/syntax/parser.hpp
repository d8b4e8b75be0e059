// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "balcony/catalogue.hpp"
#include "lang/reporter.hpp"
#include "lang/syntax/syntax.hpp"

namespace balcony::lang {

/// Parses a camera file. The catalogue is for remedies that name a stage. Errors are reported, and
/// the parts that have them are omitted or marked; the tree contains the rest.
[[nodiscard]] SyntaxTree parse(std::shared_ptr<const SourceText> source,
                               const camera::Catalogue& catalogue, Reporter& reporter);

/// Parses `name = expression`, the value of --set. The expression is the last of the tree, which
/// is empty after an error.
[[nodiscard]] SyntaxTree parse_override(std::shared_ptr<const SourceText> source,
                                        const camera::Catalogue& catalogue, Reporter& reporter);

}  // namespace balcony::lang
