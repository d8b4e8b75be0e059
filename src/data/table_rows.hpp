// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "balcony/data.hpp"

namespace balcony::data {

/// The rows of a text, or of some of its lines, of which the first may be a header; there may be
/// none.
[[nodiscard]] Result<NumberTable> read_rows(std::shared_ptr<const SourceText> source,
                                            bool may_have_header);
[[nodiscard]] Diagnostic no_numbers(const std::string& name);

}  // namespace balcony::data
