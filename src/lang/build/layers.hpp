// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "lang/names/session.hpp"

namespace balcony::lang {

/// A layer of a picture. A statement in loops is one layer for each of their passes.
struct LayerPlace {
    const Statement& statement;
    Scope& names;  ///< Those that are visible there, with the variables of the loops.
    /// What distinguishes it from other passes: "[2]", or "[2][0]" in two loops.
    std::string key{};
    std::string where{};  ///< The same for people: "i = 2, j = 0".
};

/// Visits the layers of a picture from back to front until one of them returns false. Mistakes of
/// loops are reported, and those in a pass get a note that says which.
void visit_layers(const LocatedDefinition& picture, Scope& names, Session& session,
                  const std::function<bool(const LayerPlace&)>& visit);

}  // namespace balcony::lang
