// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Base: source text and spans, diagnostics, results, strong indices.
//
// The library never prints, exits or aborts. Whatever a user should be told is a Diagnostic; a
// function that can fail on bad input returns a Result. A broken invariant of the library itself
// is an assertion.

#include <cassert>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace balcony {

/// An index that cannot be mixed up with an index of another kind. The default value is invalid.
template <class Tag>
class StrongIndex {
public:
    constexpr StrongIndex() = default;
    constexpr explicit StrongIndex(std::size_t value) : value_(static_cast<std::uint32_t>(value)) {
        assert(value < invalid_value);
    }

    [[nodiscard]] constexpr std::uint32_t value() const { return value_; }
    [[nodiscard]] constexpr bool valid() const { return value_ != invalid_value; }
    constexpr auto operator<=>(const StrongIndex&) const = default;

private:
    static constexpr std::uint32_t invalid_value = 0xffffffffU;
    std::uint32_t value_ = invalid_value;
};

/// A position for people: line and column count from 1, the column in code points.
struct LineColumn {
    std::size_t line = 1;
    std::size_t column = 1;
};

/// A text with the name under which the user knows it (a file name, "--set", ...). Immutable. A
/// byte order mark that opens the text is dropped; offsets count from behind it.
class SourceText {
public:
    SourceText(std::string name, std::string text);

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] std::string_view text() const { return text_; }
    [[nodiscard]] std::size_t line_count() const { return line_begins_.size(); }

    /// Where a byte offset lies; an offset past the end counts as the end.
    [[nodiscard]] LineColumn locate(std::size_t offset) const;

    /// The text of a line (from 1) without its line break.
    [[nodiscard]] std::string_view line(std::size_t number) const;

private:
    std::string name_;
    std::string text_;
    std::vector<std::size_t> line_begins_;
};

enum class LineFeeds : bool { replace, keep };

/// A text that a terminal shows as it is, whoever wrote it: what would act on the terminal, reorder
/// or hide text becomes '?' (control codes, marks of direction, separators of lines, characters
/// without width, bytes that are no UTF-8), and a tab becomes a space.
[[nodiscard]] std::string printable(std::string_view text,
                                    LineFeeds line_feeds = LineFeeds::replace);

/// The bytes [begin, end) of a source; without a source it points nowhere.
struct SourceSpan {
    std::shared_ptr<const SourceText> source;
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// The smallest span that holds both; both must have the same source.
[[nodiscard]] SourceSpan join(const SourceSpan& first, const SourceSpan& last);

enum class Severity : std::uint8_t { warning, error };

/// Something to tell the user: what is wrong, where, and what to do about it.
struct Diagnostic {
    struct Note {
        SourceSpan span;
        std::string message;
    };

    Severity severity = Severity::error;
    std::string message;      ///< One sentence, no full stop, names the thing that is wrong.
    SourceSpan span;          ///< Where; may point nowhere.
    std::string remedy;       ///< What to do; may be empty.
    std::vector<Note> notes;  ///< Other places that matter, such as an earlier definition.
};

using Diagnostics = std::vector<Diagnostic>;

[[nodiscard]] Diagnostic error(std::string message, SourceSpan span = {}, std::string remedy = {});
[[nodiscard]] Diagnostic warning(std::string message, SourceSpan span = {},
                                 std::string remedy = {});
[[nodiscard]] bool has_errors(const Diagnostics& diagnostics);

/// Prints a diagnostic with its place, the line it is about and the part underlined:
///
///     gallery.cam:4:15: error: there is no stage named 'superelipse'
///        4 |     eye product(superelipse(1, b/a, gamma), ...
///          |                 ^~~~~~~~~~~
///       help: did you mean 'superellipse'?
///
/// Safe for a terminal whatever the source and the messages hold, as printable() makes it.
[[nodiscard]] std::string to_text(const Diagnostic& diagnostic);
[[nodiscard]] std::string to_text(const Diagnostics& diagnostics);

/// A value, if one could be made, with everything there is to say about the making. Warnings may
/// come with a value; without a value there is at least one error.
template <class T>
struct Result {
    std::optional<T> value;
    Diagnostics diagnostics;

    Result() = default;
    Result(T made) : value(std::move(made)) {}
    Result(T made, Diagnostics said) : value(std::move(made)), diagnostics(std::move(said)) {}
    Result(Diagnostics said) : diagnostics(std::move(said)) { assert(has_errors(diagnostics)); }
    Result(Diagnostic said) : diagnostics{std::move(said)} { assert(has_errors(diagnostics)); }

    [[nodiscard]] explicit operator bool() const { return value.has_value(); }
    [[nodiscard]] T& operator*() { return *value; }
    [[nodiscard]] const T& operator*() const { return *value; }
    [[nodiscard]] T* operator->() { return &*value; }
    [[nodiscard]] const T* operator->() const { return &*value; }
};

/// Which way is up; y_up is glTF's and OBJ's, z_up the cameras' own.
enum class Axes : std::uint8_t { y_up, z_up };

/// A point or a vector, anything with x, y and z, in other axes: z_up (x, y, z) is y_up (x, z, -y).
template <class Vector>
[[nodiscard]] Vector turned(const Vector& v, Axes from, Axes to) {
    if (from == to) {
        return v;
    }
    return to == Axes::y_up ? Vector{v.x, v.z, -v.y} : Vector{v.x, -v.z, v.y};
}

/// The candidate nearest to a mistyped name by Damerau-Levenshtein distance, letter case aside, if
/// one is near enough to be what was meant: at most a third of the name's letters wrong, or one
/// letter in a name of two.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view name,
                                                      const std::vector<std::string>& candidates);

}  // namespace balcony
