// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "lang/build/stages.hpp"
#include "lang/build/statements.hpp"

namespace balcony::lang {

/// The picture mapper of a map statement; null after an error, which is reported, and if there is
/// no such statement.
[[nodiscard]] camera::PictureMapperPointer build_map(const Statements& statements,
                                                     const SyntaxTree& tree, StageBuilder& stages,
                                                     Reporter& reporter);

}  // namespace balcony::lang
