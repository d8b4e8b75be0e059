// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace balcony::app {

/// A size in bytes: "500MB", "4GiB", "2G"; nothing if it cannot be read.
[[nodiscard]] std::optional<double> bytes_of(std::string_view word);
/// The shortest word of binary units that bytes_of() reads as the size: "1GiB".
[[nodiscard]] std::string bytes_word(double bytes);

/// A duration in seconds: "90", "90s", "1.5min", "1h30min"; nothing if it cannot be read.
[[nodiscard]] std::optional<double> duration_of(std::string_view word);

}  // namespace balcony::app
