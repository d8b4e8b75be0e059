// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Describes rows of the catalogue as text.

#include <string>
#include <string_view>

#include "balcony/catalogue.hpp"

namespace balcony::camera {

/// "number", "(a, b)", "x, y, z or (a, b, c)", ...
[[nodiscard]] std::string type_text(const StageParameter& parameter);

/// The default in the notation of a camera file; empty if there is none.
[[nodiscard]] std::string default_text(const StageParameter& parameter);

/// "above 0", "-1 to 1", ...; empty if all values are valid.
[[nodiscard]] std::string range_text(const StageParameter& parameter);

/// The lines of its formula, without empty ones at the begin and end.
[[nodiscard]] std::string_view stage_formula(const StageEntry& row);

/// "torus(major, minor)", "curve(u) = [x, y, z]".
[[nodiscard]] std::string call_text(const StageEntry& row);

}  // namespace balcony::camera
