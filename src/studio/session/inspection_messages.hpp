// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Questions about a picture in the words of the protocol. These functions throw a Refusal or an
// exception of the JSON library if what is asked has not its form or has no answer.

#include <stop_token>

#include <nlohmann/json_fwd.hpp>

#include "balcony/inspect.hpp"

namespace balcony::studio {

/// What stands at a point of the picture.
[[nodiscard]] nlohmann::json sight_answer(live::Inspector& inspector, const nlohmann::json& asked,
                                          const std::stop_token& stop);
/// The same in the middles of the cells of a grid.
[[nodiscard]] nlohmann::json grid_answer(live::Inspector& inspector, const nlohmann::json& asked,
                                         const std::stop_token& stop);
/// Where a point of space appears.
[[nodiscard]] nlohmann::json places_answer(live::Inspector& inspector, const nlohmann::json& asked,
                                           const std::stop_token& stop);
/// What is wrong with the cameras of the picture, or worth knowing.
[[nodiscard]] nlohmann::json remarks_answer(live::Inspector& inspector, const nlohmann::json& asked,
                                            const std::stop_token& stop);
/// The camera of the picture in another language.
[[nodiscard]] nlohmann::json export_answer(live::Inspector& inspector, const nlohmann::json& asked,
                                           const std::stop_token& stop);

}  // namespace balcony::studio
