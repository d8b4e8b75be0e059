// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Remedies as changes of the text: those that say what to write in the place of the span, before it
// or instead of it.

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "balcony/language_service.hpp"

namespace balcony::lang {

namespace {

// The words in quotation marks.
std::vector<std::string> quoted_words(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t begin = text.find('\''); begin != std::string_view::npos;) {
        const std::size_t end = text.find('\'', begin + 1);
        if (end == std::string_view::npos) {
            break;
        }
        words.emplace_back(text.substr(begin + 1, end - begin - 1));
        begin = text.find('\'', end + 1);
    }
    return words;
}

bool is_word(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '.' || c == '-';
    });
}

// Where the misspelled word stands in the span; a file name is in quotation marks.
std::optional<TextEdit> misspelled(const Diagnostic& diagnostic) {
    const SourceSpan& span = diagnostic.span;
    std::string_view written = span.source->text().substr(span.begin, span.end - span.begin);
    const bool is_text = written.size() >= 2 && written.starts_with('"') && written.ends_with('"');
    const std::size_t mark = is_text ? 1 : 0;
    written = written.substr(mark, written.size() - 2 * mark);
    const std::vector<std::string> said = quoted_words(diagnostic.message);
    const bool is_said = std::find(said.begin(), said.end(), written) != said.end();
    return is_word(written) && is_said
               ? std::optional(TextEdit{span.begin + mark, span.end - mark, {}})
               : std::nullopt;
}

}  // namespace

std::vector<Fix> fixes_of(const Diagnostic& diagnostic) {
    const std::string_view remedy = diagnostic.remedy;
    const SourceSpan& span = diagnostic.span;
    if (!span.source || span.begin >= span.end) {
        return {};
    }
    std::vector<Fix> fixes;
    const std::vector<std::string> words = quoted_words(remedy);
    if (remedy.starts_with("did you mean '") && remedy.ends_with('?')) {
        if (const auto place = misspelled(diagnostic)) {
            for (const std::string& word : words) {
                fixes.push_back(
                    {fmt::format("write '{}'", word), {place->begin, place->end, word}});
            }
        }
    } else if (remedy.starts_with("write '") &&
               remedy.find("' before '") != std::string_view::npos && words.size() == 2) {
        fixes.push_back({std::string(remedy), {span.begin, span.begin, words.front() + " "}});
    } else if (remedy.starts_with("write '") &&
               remedy.find("' instead of '") != std::string_view::npos && words.size() == 2) {
        fixes.push_back({std::string(remedy), {span.begin, span.end, words.front()}});
    }
    return fixes;
}

}  // namespace balcony::lang
