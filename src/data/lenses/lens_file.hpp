// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the readers of prescriptions share: lines as words with their places.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/data.hpp"

namespace balcony::data {

struct LensWord {
    std::string_view text;
    SourceSpan span;
};

/// The words of a line, at least one.
using LensLine = std::vector<LensWord>;

/// The lines of a text that have words. What follows `comment` in a line is none, unless it is 0.
[[nodiscard]] std::vector<LensLine> lens_lines(const std::shared_ptr<const SourceText>& source,
                                               char comment);
[[nodiscard]] SourceSpan span_of(const LensLine& line);

/// A finite number; otherwise reports an error.
[[nodiscard]] std::optional<double> lens_number(const LensWord& word, Diagnostics& found);
/// The length of a unit in millimetres; otherwise reports an error.
[[nodiscard]] std::optional<double> lens_unit(const LensWord& word, Diagnostics& found);

[[nodiscard]] Diagnostic unknown_glass(const LensWord& name, std::vector<std::string> known);

/// Readers of the formats: a prescription of lengths in millimetres, or errors.
[[nodiscard]] camera::Prescription read_lens_table(const std::shared_ptr<const SourceText>& source,
                                                   Diagnostics& found);
[[nodiscard]] camera::Prescription read_zemax(const std::shared_ptr<const SourceText>& source,
                                              Diagnostics& found);

}  // namespace balcony::data
