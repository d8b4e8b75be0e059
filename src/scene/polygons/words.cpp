// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/polygons/words.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "balcony/input_file.hpp"
#include "scene/import.hpp"

namespace balcony::scene {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

void remove_blanks(std::string_view& text) {
    const auto word = std::find_if_not(text.begin(), text.end(), is_blank);
    text.remove_prefix(static_cast<std::size_t>(word - text.begin()));
}

// The next line, without blanks at its end.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!line.empty() && is_blank(line.back())) {
        line.remove_suffix(1);
    }
    return line;
}

}  // namespace

std::string_view text_of(std::span<const std::uint8_t> bytes, const std::filesystem::path& file) {
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (const std::optional<Diagnostic> fault = begin_text(text, in_quotes(file.string()))) {
        throw ReadError{*fault};
    }
    return text;
}

Statement take_statement(std::string_view& text, std::string& joined) {
    std::string_view line = take_line(text);
    if (line.ends_with('\\') && !line.starts_with('#')) {
        joined = line.substr(0, line.size() - 1);
        bool goes_on = true;
        while (goes_on && !text.empty()) {
            const std::string_view next = take_line(text);
            goes_on = next.ends_with('\\');
            joined += ' ';
            joined += next.substr(0, next.size() - (goes_on ? 1 : 0));
        }
        line = joined;
    }
    Statement statement;
    statement.keyword = take_word(line);
    if (statement.keyword.starts_with('#')) {
        return {};
    }
    remove_blanks(line);
    statement.arguments = line;
    return statement;
}

std::string_view take_word(std::string_view& arguments) {
    remove_blanks(arguments);
    const auto end = std::find_if(arguments.begin(), arguments.end(), is_blank);
    const std::string_view word =
        arguments.substr(0, static_cast<std::size_t>(end - arguments.begin()));
    arguments.remove_prefix(word.size());
    return word;
}

bool to_number(std::string_view word, double& number) {
    if (word.starts_with('+')) {
        word.remove_prefix(1);
    }
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), number);
    return code == std::errc() && end == word.data() + word.size() && !word.empty();
}

bool to_float(std::string_view word, float& number) {
    // Converts via double: a number too small for a float is zero, not an error.
    double value = 0.0;
    if (!to_number(word, value)) {
        return false;
    }
    number = static_cast<float>(value);
    return std::isfinite(number);
}

}  // namespace balcony::scene
