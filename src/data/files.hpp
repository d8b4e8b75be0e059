// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/data.hpp"

namespace balcony::data {

/// The size of a file in bytes.
[[nodiscard]] Result<std::uintmax_t> size_of(const File& file);
/// The contents of a file of at most `largest` bytes.
[[nodiscard]] Result<std::string> read_text(const File& file, std::size_t largest);
[[nodiscard]] Diagnostic cannot_read(const File& file);

}  // namespace balcony::data
