// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace balcony {

/// The most memory that this process has held so far, in bytes; 0 if the system does not tell.
[[nodiscard]] std::uint64_t peak_memory();

/// That of the machine, in bytes; negative if the system does not tell.
[[nodiscard]] double physical_memory();

}  // namespace balcony
