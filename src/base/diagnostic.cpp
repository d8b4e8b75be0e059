// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "balcony/base.hpp"
#include "base/utf8.hpp"

namespace balcony {

namespace {

constexpr std::size_t excerpt_columns = 100;

std::size_t columns(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return !continues_code_point(c); }));
}

// The start of the code point at or before an offset; for invalid UTF-8, the
// offset itself.
std::size_t code_point_begin(std::string_view text, std::size_t offset) {
    for (std::size_t back = 0; back < 4 && back <= offset; ++back) {
        const std::size_t at = offset - back;
        if (at == text.size() || !continues_code_point(text[at])) {
            return at;
        }
    }
    return offset;
}

// The line of a span with the span underlined; a span over several lines is underlined to the end
// of its first. Of a very long line, only a part is shown.
std::string excerpt(const SourceSpan& span) {
    const LineColumn place = span.source->locate(span.begin);
    const std::string_view line = span.source->line(place.line);
    const auto line_begin = static_cast<std::size_t>(line.data() - span.source->text().data());
    const std::size_t begin =
        code_point_begin(line, std::min(span.begin - line_begin, line.size()));
    const std::size_t last = std::max(span.begin, span.end) - line_begin;
    const std::size_t end =
        std::max(begin, code_point_begin(line, std::clamp(last, begin, line.size())));

    std::size_t from = 0;
    std::size_t to = line.size();
    if (line.size() > excerpt_columns) {
        from = code_point_begin(line, begin - std::min(begin, excerpt_columns / 2));
        to = code_point_begin(line, std::min(line.size(), from + excerpt_columns));
    }
    const std::size_t marked_end = std::min(end, to);
    const std::string before = (from > 0 ? "..." : "") + printable(line.substr(from, begin - from));
    const std::string marked = printable(line.substr(begin, marked_end - begin));
    const std::string after =
        printable(line.substr(marked_end, to - marked_end)) + (to < line.size() ? "..." : "");

    const std::string number = fmt::format("{:>5}", place.line);
    const std::string underline(std::max<std::size_t>(columns(marked), 1) - 1, '~');
    return fmt::format("{} | {}{}{}\n{:{}} | {:{}}^{}\n", number, before, marked, after, "",
                       number.size(), "", columns(before), underline);
}

std::string where(const SourceSpan& span) {
    if (!span.source) {
        return {};
    }
    const LineColumn place = span.source->locate(span.begin);
    return fmt::format("{}:{}:{}: ", printable(span.source->name()), place.line, place.column);
}

}  // namespace

std::string_view name_of(Kind kind) {
    constexpr std::array<std::string_view, 5> names{"input", "usage", "environment", "interrupted",
                                                    "internal"};
    return names[static_cast<std::size_t>(kind)];
}

Diagnostic error(std::string message, SourceSpan span, std::string remedy) {
    return {Severity::error, std::move(message), std::move(span), std::move(remedy), {}};
}

Diagnostic error(Kind kind, std::string message, std::string remedy) {
    return {Severity::error, std::move(message), {}, std::move(remedy), {}, kind};
}

Diagnostic warning(std::string message, SourceSpan span, std::string remedy) {
    return {Severity::warning, std::move(message), std::move(span), std::move(remedy), {}};
}

std::optional<Kind> kind_of_errors(const Diagnostics& diagnostics) {
    const auto first = std::find_if(
        diagnostics.begin(), diagnostics.end(),
        [](const Diagnostic& diagnostic) { return diagnostic.severity == Severity::error; });
    return first == diagnostics.end() ? std::nullopt : std::optional(first->kind);
}

bool has_errors(const Diagnostics& diagnostics) { return kind_of_errors(diagnostics).has_value(); }

std::string to_text(const Diagnostic& diagnostic) {
    const char* kind = diagnostic.severity == Severity::error ? "error" : "warning";
    std::string text =
        fmt::format("{}{}: {}\n", where(diagnostic.span), kind, printable(diagnostic.message));
    if (diagnostic.span.source) {
        text += excerpt(diagnostic.span);
    }
    for (const Diagnostic::Note& note : diagnostic.notes) {
        text += fmt::format("{}note: {}\n", where(note.span), printable(note.message));
        if (note.span.source) {
            text += excerpt(note.span);
        }
    }
    if (!diagnostic.remedy.empty()) {
        text += fmt::format("  help: {}\n", printable(diagnostic.remedy));
    }
    return text;
}

std::string to_text(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) {
        text += to_text(diagnostic);
    }
    return text;
}

}  // namespace balcony
