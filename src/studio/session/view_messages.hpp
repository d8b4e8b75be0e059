// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A view in the words of the protocol.

#include <cstddef>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "balcony/live.hpp"

namespace balcony::studio {

/// What a page asks for. Throws a Refusal or an exception of the JSON library if it has not the
/// form of a change.
[[nodiscard]] live::Change change_of(const nlohmann::json& asked);
[[nodiscard]] std::vector<live::Value> values_of(const nlohmann::json& asked);
[[nodiscard]] live::Drag drag_of(const nlohmann::json& asked);
[[nodiscard]] Imath::V3d point_of(const nlohmann::json& asked);
[[nodiscard]] std::size_t index_of(const nlohmann::json& asked);
/// A number from 1; `what` it is begins the message.
[[nodiscard]] std::size_t count_of(const nlohmann::json& asked, std::size_t most,
                                   std::string_view what);

/// What a page may choose from: the names of rows, with a line for each.
template <class Rows>
[[nodiscard]] nlohmann::json choices_of(const Rows& rows) {
    nlohmann::json made = nlohmann::json::array();
    for (const auto& one : rows) {
        made.push_back({{"name", one.name}, {"meaning", one.meaning}});
    }
    return made;
}

/// As a text shows them that is the view's.
[[nodiscard]] nlohmann::json told_of(const Diagnostics& found);
/// The parameters of view/camera, of studio/scene and of view/dragged.
[[nodiscard]] nlohmann::json told_of(const live::CameraState& state);
[[nodiscard]] nlohmann::json told_of(const live::SceneState& state);
[[nodiscard]] nlohmann::json told_of(const live::Dragged& dragged);

}  // namespace balcony::studio
