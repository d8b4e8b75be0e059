// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What C and the languages that look like it share: definitions, sections with comments, and
// functions that look into tables.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bridge/text/listing.hpp"

namespace balcony::bridge {

struct CLike {
    std::string_view real;       ///< The type of numbers.
    std::string_view condition;  ///< The type of conditions.
    std::string_view constant;   ///< Before the type of what does not change: "const ".
    std::string_view local;      ///< Before a function: "static ".
    std::string_view floor;      ///< The function that rounds down.
    std::string_view truncate;   ///< The whole part of a number as an integer: "(int){0}".
    std::string (*number)(double value);
    /// A constant array of numbers: a definition of some name with some values.
    std::string (*array)(std::string_view name, const std::vector<std::string>& values);
    /// If it is not empty: the function of an index that gives the numbers of all tables, one table
    /// after another. Then no array is written.
    std::string_view table_numbers{};
};

/// The definitions of a listing, each on a line with a margin of four spaces; each section after
/// its comment.
[[nodiscard]] std::string definitions(const CLike& language, const Listing& listing);

/// The functions that the definitions call: helpers, and one for each table that returns its value.
[[nodiscard]] std::string functions(const CLike& language, const Listing& listing);

/// The names that a text gives to open parameters, in their order.
class ParameterNames {
public:
    ParameterNames(const std::vector<ExportParameter>& parameters, Names& names);

    [[nodiscard]] std::size_t size() const { return names_.size(); }
    [[nodiscard]] const std::string& operator[](std::size_t i) const { return names_[i]; }
    [[nodiscard]] auto begin() const { return names_.begin(); }
    [[nodiscard]] auto end() const { return names_.end(); }
    /// Which parameter is an input of the formulas; nothing if it is another input.
    [[nodiscard]] std::optional<std::size_t> of_input(std::string_view input) const;

private:
    std::vector<std::string> names_;
    std::vector<std::string> inputs_;
};

/// What the text of every language says first: which camera it is, and what its author says.
[[nodiscard]] std::vector<std::string> opening_lines(const ExportSource& source);
/// One sentence about the axes of the rays.
[[nodiscard]] std::string world(Axes axes);

/// Lines that begin with the mark of a comment.
[[nodiscard]] std::string commented(const std::vector<std::string>& lines,
                                    std::string_view mark = "//");

/// The lines of a text.
[[nodiscard]] std::vector<std::string> lines_of(std::string_view text);

}  // namespace balcony::bridge
