// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/render.hpp"

namespace balcony::render {

/// What is out of range, and names that nothing has.
[[nodiscard]] Diagnostics check(const Settings& settings);

}  // namespace balcony::render
