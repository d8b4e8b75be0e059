// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "balcony/base.hpp"

namespace balcony::app {

/// "1 frame", "3 frames"
[[nodiscard]] std::string counted(std::size_t count, std::string_view one, std::string_view many);

/// The whole text as a number without a sign, or nothing.
[[nodiscard]] std::optional<std::size_t> whole_number_of(std::string_view text);

/// The extension of a file name in lower case, including the dot.
[[nodiscard]] std::string ending_of(const std::string& file);

void add(Diagnostics& diagnostics, const Diagnostics& more);

/// The same diagnostics, whose errors are of this kind.
[[nodiscard]] Diagnostics of_kind(Kind kind, Diagnostics diagnostics);

}  // namespace balcony::app
