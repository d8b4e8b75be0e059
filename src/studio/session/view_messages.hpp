// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A view in the words of the protocol.

#include <nlohmann/json_fwd.hpp>

#include "balcony/live.hpp"

namespace balcony::studio {

/// What a page asks for. Throws a Refusal or an exception of the JSON library if it has not the
/// form of a change.
[[nodiscard]] live::Change change_of(const nlohmann::json& asked);
[[nodiscard]] std::vector<live::Value> values_of(const nlohmann::json& asked);

/// The parameters of view/camera and of studio/scene.
[[nodiscard]] nlohmann::json told_of(const live::CameraState& state);
[[nodiscard]] nlohmann::json told_of(const live::SceneState& state);

}  // namespace balcony::studio
