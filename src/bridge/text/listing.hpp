// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A camera's formulas as a list of definitions, stage by stage, in the words of a language.

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bridge/text/camera_formulas.hpp"
#include "bridge/text/spelling.hpp"

namespace balcony::bridge {

/// How a language writes formulas.
struct Dialect {
    const Spellings& spellings;
    std::string (*number)(double value);
    /// A condition where a number is needed, and a number where a condition is needed: patterns.
    std::string_view number_of_condition = "{0}";
    std::string_view condition_of_number = "{0}";
    bool single = false;  ///< Numbers are single precision, and tables as coarse as they allow.
    /// Before and behind the names of the library's functions: "np." or "f".
    std::string_view before_standard{};
    std::string_view behind_standard{};
    /// What stands for an operand {0} that has a harmless number {1} (unused_branches.hpp), for
    /// languages that take derivatives; nothing if the operand stands for itself.
    std::string_view guarded{};
    /// Words in spellings and what stands for them, such as the type of numbers.
    std::vector<std::pair<std::string, std::string>> words{};

    /// A text of a spelling with its words replaced.
    [[nodiscard]] std::string spelled(std::string_view text) const;
};

/// Names that are taken; each name is given once.
class Names {
public:
    /// No name begins with the reserved prefix, if there is one.
    explicit Names(const std::set<std::string_view>& reserved = {},
                   std::string_view reserved_prefix = {});
    /// The name itself, made of ASCII letters, digits and underscores, or with a number behind it.
    [[nodiscard]] std::string unique(std::string_view wanted);

private:
    std::set<std::string, std::less<>> taken_;
    std::string_view reserved_prefix_;
};

/// A shared part of the formulas: NAME = TEXT.
struct ListedLine {
    std::string name;
    std::string text;
    bool condition = false;
    /// The names in the text: of earlier lines and of inputs.
    std::set<std::string> uses{};
};

struct ListedSection {
    std::string comment;  ///< The stage, as the camera's file writes it.
    /// None if the formulas of the stage are part of what follows.
    std::vector<ListedLine> lines;
};

struct ListedTable {
    std::shared_ptr<const expr::Table> table;
    std::string name;
};

struct Listing {
    std::vector<ListedSection> sections;
    std::vector<ListedLine> roots;  ///< The roots of the formulas; their names are empty.
    std::vector<ListedTable> tables;
    std::vector<std::string> helpers;  ///< Definitions that the lines need.

    /// Whether any line or root depends on a name.
    [[nodiscard]] bool uses(const std::string& name) const;
};

/// What stands for an input of the graph.
using InputText = std::function<std::string(std::string_view input)>;

/// Functions of the text are named with a prefix, so that several cameras fit into one program.
[[nodiscard]] Listing listing_of(const CameraFormulas& formulas, const Dialect& dialect,
                                 Names& names, std::string_view prefix,
                                 const InputText& input_text);

/// A text with each occurrence of a word replaced.
[[nodiscard]] std::string replaced(std::string text, std::string_view word, std::string_view by);

/// A pattern with {0}, {1}, ... replaced.
[[nodiscard]] std::string filled(std::string_view pattern,
                                 const std::vector<std::string>& operands);

/// Numbers with commas between them, several on each line behind a margin.
[[nodiscard]] std::string wrapped(const std::vector<std::string>& numbers, std::size_t margin);

/// The shortest decimal number with a point or an exponent that reads as the same double or float.
[[nodiscard]] std::string decimal(double value);
[[nodiscard]] std::string single_decimal(double value);

/// A text that is safe behind the mark of a comment: one line, no backslash.
[[nodiscard]] std::string comment_line(std::string_view text);

}  // namespace balcony::bridge
