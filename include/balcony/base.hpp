// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Base: source text and spans, diagnostics, results, strong indices.
//
// The library never prints, exits or aborts. Messages to the user are Diagnostics; a
// function that can fail on bad input returns a Result. A violated invariant of the library
// is an assertion failure.

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

/// A strongly typed index. The default value is invalid.
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

/// A readable position: line and column, counted from 1, the column in code points.
struct LineColumn {
    std::size_t line = 1;
    std::size_t column = 1;
};

/// A text with a name for the user (a file name, "--set", ...). Immutable. A
/// byte order mark at the start is removed; offsets are relative to the text after it.
class SourceText {
public:
    SourceText(std::string name, std::string text);

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] std::string_view text() const { return text_; }
    [[nodiscard]] std::size_t line_count() const { return line_begins_.size(); }

    /// The position of a byte offset; an offset past the end is clamped to the end.
    [[nodiscard]] LineColumn locate(std::size_t offset) const;

    /// The text of a line (from 1) without its line break.
    [[nodiscard]] std::string_view line(std::size_t number) const;

private:
    std::string name_;
    std::string text_;
    std::vector<std::size_t> line_begins_;
};

enum class LineFeeds : bool { replace, keep };

/// Makes an untrusted text safe for a terminal. Characters that would control the terminal, reorder
/// or hide text become '?' (control codes, direction marks, line separators, characters
/// without width, invalid UTF-8), and a tab becomes a space.
[[nodiscard]] std::string printable(std::string_view text,
                                    LineFeeds line_feeds = LineFeeds::replace);

/// The bytes [begin, end) of a source; without a source, it is no position.
struct SourceSpan {
    std::shared_ptr<const SourceText> source;
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// The smallest span that contains both; both must have the same source.
[[nodiscard]] SourceSpan join(const SourceSpan& first, const SourceSpan& last);

enum class Severity : std::uint8_t { warning, error };

/// What a program can do about a diagnostic.
enum class Kind : std::uint8_t {
    input,        ///< A file, a camera or a value is wrong: correct it.
    usage,        ///< What was asked for cannot be done: ask otherwise.
    environment,  ///< The machine: a full disk, a missing library or program, too little memory.
    interrupted,  ///< Stopped on request.
    internal,     ///< A precondition of the library was violated: a defect of the calling program.
};

/// The name of a kind, as programs read it: "input".
[[nodiscard]] std::string_view name_of(Kind kind);

/// An error or a warning for the user: what is wrong, where, and a suggested fix.
struct Diagnostic {
    struct Note {
        SourceSpan span;
        std::string message;
    };

    Severity severity = Severity::error;
    std::string message;      ///< One sentence without a full stop that names the incorrect item.
    SourceSpan span;          ///< The position; may be empty.
    std::string remedy;       ///< A suggested fix; may be empty.
    std::vector<Note> notes;  ///< Other relevant positions, such as an earlier definition.
    Kind kind = Kind::input;
};

using Diagnostics = std::vector<Diagnostic>;

/// Of Kind::input, unless another kind is named.
[[nodiscard]] Diagnostic error(std::string message, SourceSpan span = {}, std::string remedy = {});
[[nodiscard]] Diagnostic error(Kind kind, std::string message, std::string remedy = {});
[[nodiscard]] Diagnostic warning(std::string message, SourceSpan span = {},
                                 std::string remedy = {});
[[nodiscard]] bool has_errors(const Diagnostics& diagnostics);

/// The kind of the first error; nothing if there is none.
[[nodiscard]] std::optional<Kind> kind_of_errors(const Diagnostics& diagnostics);

/// Formats a diagnostic with its position and its source line, with the span underlined:
///
///     gallery.cam:4:15: error: there is no stage named 'superelipse'
///        4 |     eye product(superelipse(1, b/a, gamma), ...
///          |                 ^~~~~~~~~~~
///       help: did you mean 'superellipse'?
///
/// The result is safe for a terminal, as by printable().
[[nodiscard]] std::string to_text(const Diagnostic& diagnostic);
[[nodiscard]] std::string to_text(const Diagnostics& diagnostics);

/// The result of a function that can fail: a value, if there is one, with diagnostics. Warnings may
/// accompany a value; without a value there is at least one error.
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

/// The vertical axis: y_up for glTF and OBJ, z_up by default for cameras.
enum class Axes : std::uint8_t { y_up, z_up };

/// A point or a vector, anything with x, y and z, in other axes: z_up (x, y, z) is y_up (x, z, -y).
template <class Vector>
[[nodiscard]] Vector turned(const Vector& v, Axes from, Axes to) {
    if (from == to) {
        return v;
    }
    return to == Axes::y_up ? Vector{v.x, v.z, -v.y} : Vector{v.x, -v.z, v.y};
}

/// The candidate nearest to a mistyped name by case-insensitive Damerau-Levenshtein distance, if
/// one is near enough: at most a third of the name's letters differ, or one
/// letter in a name of two.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view name,
                                                      const std::vector<std::string>& candidates);

}  // namespace balcony
