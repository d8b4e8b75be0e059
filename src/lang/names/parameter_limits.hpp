// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/catalogue.hpp"
#include "lang/names/session.hpp"

namespace balcony::lang {

/// The values that a parameter may have: fov = 60deg above 0 to 179deg. Mistakes in its limits are
/// reported; it then has none.
[[nodiscard]] camera::Range limits_of(const LocatedDefinition& place,
                                      const DefinitionParameter& parameter, Session& session);

/// A value within the limits of a parameter. A constant beyond them is reported, and the value has
/// then failed. One that changes with time is held within them; if it is beyond them at a key, a
/// warning says so.
[[nodiscard]] Value within_limits(const Value& value, const SourceSpan& span,
                                  const LocatedDefinition& place,
                                  const DefinitionParameter& parameter, Session& session);

}  // namespace balcony::lang
