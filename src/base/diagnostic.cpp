// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include <fmt/format.h>

#include "balcony/base.hpp"

namespace balcony {

namespace {

constexpr std::size_t excerpt_columns = 100;

// A piece of source text as it can safely be shown on a terminal: tabs become single spaces, so
// that the underline stays below its text, and control or undecodable bytes become '?'.
std::string printable(std::string_view bytes) {
    std::string shown;
    for (std::size_t i = 0; i < bytes.size();) {
        const auto byte = static_cast<unsigned char>(bytes[i]);
        const std::size_t length = byte < 0x80 ? 1 : byte >> 5 == 6 ? 2 : byte >> 4 == 14 ? 3 : byte >> 3 == 30 ? 4 : 0;
        bool well_formed = length > 0 && i + length <= bytes.size();
        for (std::size_t k = 1; well_formed && k < length; ++k) {
            well_formed = (static_cast<unsigned char>(bytes[i + k]) & 0xc0U) == 0x80U;
        }
        if (!well_formed || byte == 0x7f || (byte < 0x20 && byte != '\t')) {
            shown += '?';
            ++i;
        } else if (byte == '\t') {
            shown += ' ';
            ++i;
        } else {
            shown += bytes.substr(i, length);
            i += length;
        }
    }
    return shown;
}

std::size_t columns(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xc0U) != 0x80U;
    }));
}

// The line of a span with the span underlined; a span over several lines is underlined to the end
// of its first. Only a window of a very long line is shown.
std::string excerpt(const SourceSpan& span) {
    const LineColumn place = span.source->locate(span.begin);
    const std::string_view line = span.source->line(place.line);
    const auto line_begin = static_cast<std::size_t>(line.data() - span.source->text().data());
    const std::size_t begin = std::min(span.begin - line_begin, line.size());
    const std::size_t end = std::clamp(span.end - line_begin, begin, line.size());

    const std::size_t from = begin > excerpt_columns / 2 && line.size() > excerpt_columns
                                 ? begin - excerpt_columns / 2
                                 : 0;
    const std::size_t to = std::min(line.size(), from + excerpt_columns);
    const std::string before = printable(line.substr(from, begin - from));
    const std::string marked = printable(line.substr(begin, std::min(end, to) - begin));
    const std::string after = printable(line.substr(std::min(end, to), to - std::min(end, to)));

    const std::size_t width = std::max<std::size_t>(columns(marked), 1);
    return fmt::format("{:>5} | {}{}{}\n      | {:{}}^{:~<{}}\n", place.line, before, marked, after,
                       "", columns(before), "", width - 1);
}

std::string where(const SourceSpan& span) {
    if (!span.source) {
        return {};
    }
    const LineColumn place = span.source->locate(span.begin);
    return fmt::format("{}:{}:{}: ", span.source->name(), place.line, place.column);
}

}  // namespace

Diagnostic error(std::string message, SourceSpan span, std::string remedy) {
    return {Severity::error, std::move(message), std::move(span), std::move(remedy), {}};
}

Diagnostic warning(std::string message, SourceSpan span, std::string remedy) {
    return {Severity::warning, std::move(message), std::move(span), std::move(remedy), {}};
}

bool has_errors(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& diagnostic) {
        return diagnostic.severity == Severity::error;
    });
}

std::string to_text(const Diagnostic& diagnostic) {
    const char* kind = diagnostic.severity == Severity::error ? "error" : "warning";
    std::string text =
        fmt::format("{}{}: {}\n", where(diagnostic.span), kind, diagnostic.message);
    if (diagnostic.span.source) {
        text += excerpt(diagnostic.span);
    }
    for (const Diagnostic::Note& note : diagnostic.notes) {
        text += fmt::format("{}note: {}\n", where(note.span), note.message);
        if (note.span.source) {
            text += excerpt(note.span);
        }
    }
    if (!diagnostic.remedy.empty()) {
        text += fmt::format("  help: {}\n", diagnostic.remedy);
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
