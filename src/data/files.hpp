// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/data.hpp"

namespace balcony::data {

/// The size of a file in bytes.
[[nodiscard]] Result<std::uintmax_t> size_of(const File& file);
/// The contents of a file of at most `largest` bytes.
[[nodiscard]] Result<std::string> read_bytes(const File& file, std::size_t largest);
/// The same of a text in UTF-8; a byte of zero and UTF-16 are errors. `remedy` says how to export a
/// text.
[[nodiscard]] Result<std::shared_ptr<const SourceText>> read_text(const File& file,
                                                                  std::size_t largest,
                                                                  std::string_view remedy);
[[nodiscard]] Diagnostic cannot_read(const File& file);

}  // namespace balcony::data
