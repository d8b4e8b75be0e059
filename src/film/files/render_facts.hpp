// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "balcony/checkpoint.hpp"

namespace balcony::render {

/// Facts as one text, and back.
[[nodiscard]] std::string text_of(const RenderFacts& facts);
[[nodiscard]] RenderFacts facts_of(std::string_view text);

[[nodiscard]] std::optional<std::string_view> find(const RenderFacts& facts, std::string_view name);

}  // namespace balcony::render
