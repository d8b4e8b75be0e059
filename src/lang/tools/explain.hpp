// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/lang.hpp"
#include "lang/names/definition_scope.hpp"

namespace balcony::lang {

/// Explains a camera or a picture without errors, from which build_picture() has made `picture`
/// with the same parameters.
[[nodiscard]] Explanation explain(const LocatedDefinition& place, const camera::Picture& picture,
                                  const GivenParameters& given, Session& session);

}  // namespace balcony::lang
