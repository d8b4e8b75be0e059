// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/command_words.hpp"

#include <algorithm>
#include <string_view>

#include "balcony/catalogue.hpp"

namespace balcony::cli {

namespace {

// A word that begins an option. "-30deg" and "-sqrt(2)" are values; "-q" is an option.
bool is_option(std::string_view word) {
    return word.size() >= 2 && word[0] == '-' &&
           (word[1] == '-' || (word.size() == 2 && (word[1] < '0' || word[1] > '9')));
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
    const std::size_t end = text.find_last_not_of(" \t") + 1;
    return text.substr(begin, end > begin ? end - begin : 0);
}

// "fov = 60deg" without the blanks around the first equals sign, or with one in place of the first
// blank.
std::string assignment(std::string_view text) {
    text = trimmed(text);
    const std::size_t equals = text.find('=');
    const std::size_t cut = equals != std::string_view::npos ? equals : text.find_first_of(" \t");
    if (cut == std::string_view::npos) {
        return std::string(text);
    }
    return std::string(trimmed(text.substr(0, cut))) + "=" +
           std::string(trimmed(text.substr(cut + 1)));
}

// Whether an assignment still lacks its value.
bool is_open(std::string_view text) {
    return text.find('=') == std::string_view::npos || text.ends_with('=');
}

bool is_count(std::string_view word) {
    return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
}

bool is_stage(std::string_view name) {
    const auto& rows = camera::catalogue();
    return std::any_of(rows.begin(), rows.end(),
                       [name](const auto& row) { return row.name == name; });
}

}  // namespace

std::vector<std::string> command_words(std::vector<std::string> words, bool& whole_help) {
    if (!words.empty() && words.front() == "help") {
        words.erase(words.begin());
        if (words.size() == 1 && is_stage(words.front())) {
            words.insert(words.begin(), "list");
        } else {
            words.emplace_back("--help");
        }
    } else if (words.size() == 1 && words.front() == "version") {
        words.front() = "--version";
    }
    const auto asks = [](std::string_view word) { return word == "--help" || word == "-h"; };
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if ((asks(words[i]) && words[i + 1] == "all") ||
            (words[i] == "all" && asks(words[i + 1]))) {
            whole_help = true;
            words.erase(words.begin() + static_cast<std::ptrdiff_t>(words[i] == "all" ? i : i + 1));
            break;
        }
    }
    std::vector<std::string> made;
    for (std::size_t i = 0; i < words.size(); ++i) {
        made.push_back(words[i]);
        if (words[i] == "--size" && i + 2 < words.size() && is_count(words[i + 1]) &&
            is_count(words[i + 2])) {
            made.push_back(words[i + 1] + "x" + words[i + 2]);
            i += 2;
            continue;
        }
        if (words[i] != "--set" || i + 1 == words.size()) {
            continue;
        }
        std::string value = assignment(words[++i]);
        // At most "=" and the value follow.
        for (int further = 0;
             further < 2 && is_open(value) && i + 1 < words.size() && !is_option(words[i + 1]);
             ++further) {
            value = assignment(value + " " + words[++i]);
        }
        made.push_back(value);
    }
    return made;
}

}  // namespace balcony::cli
