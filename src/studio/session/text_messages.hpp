// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a hand moves of a text, in the words of the protocol. These functions throw a Refusal or an
// exception of the JSON library if what is asked has not its form.

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "balcony/language_service.hpp"

namespace balcony::studio {

/// The handles of a camera.
[[nodiscard]] nlohmann::json handles_answer(const lang::EditedText& text,
                                            const std::string& camera);
/// The edits that move one of them.
[[nodiscard]] nlohmann::json moved_answer(const lang::EditedText& text, const std::string& camera,
                                          const nlohmann::json& asked);
/// The keys of a camera's parameters.
[[nodiscard]] nlohmann::json keys_answer(const lang::EditedText& text, const std::string& camera);
/// The edits that take its keys at a time away.
[[nodiscard]] nlohmann::json without_keys_answer(const lang::EditedText& text,
                                                 const std::string& camera,
                                                 const nlohmann::json& asked);
/// The edits that give parameters other values.
[[nodiscard]] nlohmann::json values_answer(const lang::EditedText& text, const std::string& camera,
                                           const nlohmann::json& asked);

}  // namespace balcony::studio
