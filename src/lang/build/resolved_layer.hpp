// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "lang/names/definition_scope.hpp"

namespace balcony::lang {

/// A camera or a picture that has statements, with the values of its parameters: one that a layer
/// shows, or one that is made, by itself or of its base.
struct ResolvedLayer {
    LocatedDefinition place;
    GivenParameters given;
};

/// What is made of another definition becomes that one, with its values behind those that are
/// given. Returns nothing after an error, which is reported.
[[nodiscard]] std::optional<ResolvedLayer> resolve_base(ResolvedLayer written, Session& session);

/// Resolves the call of a layer in a picture with the given names. Returns nothing after an error,
/// which is reported.
[[nodiscard]] std::optional<ResolvedLayer> resolve_layer(const LocatedDefinition& picture,
                                                         const Expression& call, Scope& names,
                                                         Session& session,
                                                         std::string_view what = "a layer");

}  // namespace balcony::lang
