// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/base.hpp"
#include "cli/command.hpp"

namespace balcony::cli {

/// Writes diagnostics to standard error.
void report(const Diagnostics& diagnostics);

/// Writes a picture size, count, duration for people: 14.7 M, 3.2 s, 1:04 h.
[[nodiscard]] std::string count_text(double count);
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace balcony::cli
