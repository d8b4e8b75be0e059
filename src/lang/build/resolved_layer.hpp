// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "lang/names/definition_scope.hpp"

namespace balcony::lang {

/// The camera or picture that a layer shows, with the values of its parameters.
struct ResolvedLayer {
    LocatedDefinition place;
    GivenParameters given;
};

/// Resolves the call of a layer in a picture with the given names. Returns nothing after an error,
/// which is reported.
[[nodiscard]] std::optional<ResolvedLayer> resolve_layer(const LocatedDefinition& picture,
                                                         const Expression& call, Scope& names,
                                                         Session& session,
                                                         std::string_view what = "a layer");

}  // namespace balcony::lang
