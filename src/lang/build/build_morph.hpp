// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "lang/build/stages.hpp"
#include "lang/names/session.hpp"
#include "lang/syntax/syntax.hpp"

namespace balcony::lang {

/// What the other statements of a camera say about its morph.
struct MorphSettings {
    std::optional<double> aspect{};
    std::optional<Axes> axes{};
};

/// The parts of a camera that its morph statement makes, in the scope of the stage builder. Nothing
/// after an error, which is reported.
[[nodiscard]] std::optional<camera::Camera::Parts> build_morph(const LocatedDefinition& place,
                                                               const Statement& statement,
                                                               const MorphSettings& settings,
                                                               Scope& scope, StageBuilder& stages,
                                                               Session& session);

}  // namespace balcony::lang
