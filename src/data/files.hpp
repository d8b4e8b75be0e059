// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/data.hpp"

namespace balcony::data {

/// How many bytes a file has.
[[nodiscard]] Result<std::uintmax_t> size_of(const File& file);
/// All of a file of at most `largest` bytes.
[[nodiscard]] Result<std::string> read_text(const File& file, std::size_t largest);
[[nodiscard]] Diagnostic cannot_read(const File& file);

}  // namespace balcony::data
