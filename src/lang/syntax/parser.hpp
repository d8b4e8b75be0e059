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

/// Reads a camera file. The catalogue is for remedies that name a stage. What has errors is
/// reported and left out or marked; the rest is there.
[[nodiscard]] SyntaxTree parse(std::shared_ptr<const SourceText> source,
                               const camera::Catalogue& catalogue, Reporter& reporter);

/// Parses `name = expression`, the value of --set. The expression is the tree's last; there is none
/// if there were errors.
[[nodiscard]] SyntaxTree parse_override(std::shared_ptr<const SourceText> source,
                                        const camera::Catalogue& catalogue, Reporter& reporter);

}  // namespace balcony::lang
