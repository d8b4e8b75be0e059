// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "lang/names/definition_scope.hpp"

namespace balcony::lang {

/// The camera or picture that a layer shows, with what the layer says of its parameters.
struct ResolvedLayer {
    LocatedDefinition place;
    GivenParameters given;
};

/// What a layer's call means in a picture whose names are given; nothing if there is an error,
/// which is reported.
[[nodiscard]] std::optional<ResolvedLayer> resolve_layer(const LocatedDefinition& picture,
                                                         const Expression& call, Scope& names,
                                                         Session& session);

}  // namespace balcony::lang
