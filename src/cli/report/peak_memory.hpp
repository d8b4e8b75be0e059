// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace balcony::cli {

/// The most memory that this process has held so far, in bytes; 0 if the system does not tell.
[[nodiscard]] std::uint64_t peak_memory();

}  // namespace balcony::cli
