// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/text_edits.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

namespace balcony::studio {

namespace {

bool is_inside_character(char byte) { return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U; }

// Adds the edit of a part that begins at an offset of the whole text, if the part differs.
void add_edit(std::string_view before, std::string_view after, std::size_t offset,
              std::vector<lang::TextEdit>& edits) {
    if (before == after) {
        return;
    }
    const std::size_t shorter = std::min(before.size(), after.size());
    std::size_t begin = 0;
    while (begin < shorter && before[begin] == after[begin]) {
        ++begin;
    }
    std::size_t tail = 0;
    while (tail < shorter - begin &&
           before[before.size() - 1 - tail] == after[after.size() - 1 - tail]) {
        ++tail;
    }
    // Whole characters of UTF-8.
    while (begin > 0 && ((begin < before.size() && is_inside_character(before[begin])) ||
                         (begin < after.size() && is_inside_character(after[begin])))) {
        --begin;
    }
    while (tail > 0 && is_inside_character(before[before.size() - tail])) {
        --tail;
    }
    edits.push_back({offset + begin, offset + before.size() - tail,
                     std::string(after.substr(begin, after.size() - tail - begin))});
}

std::string_view next_line(std::string_view& rest) {
    const std::size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    return line;
}

}  // namespace

std::vector<lang::TextEdit> edits_between(std::string_view before, std::string_view after) {
    std::vector<lang::TextEdit> edits;
    if (std::count(before.begin(), before.end(), '\n') !=
        std::count(after.begin(), after.end(), '\n')) {
        add_edit(before, after, 0, edits);
        return edits;
    }
    std::string_view rest = before;
    while (!rest.empty() || !after.empty()) {
        const std::size_t offset = before.size() - rest.size();
        const std::string_view line = next_line(rest);
        add_edit(line, next_line(after), offset, edits);
    }
    return edits;
}

}  // namespace balcony::studio
