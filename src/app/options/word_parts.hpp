// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <string_view>
#include <vector>

namespace balcony::app {

inline constexpr double degree = std::numbers::pi / 180.0;

/// The parts of a word between separators, of which each is one character.
[[nodiscard]] inline std::vector<std::string_view> parts_of(std::string_view word,
                                                            std::string_view separators) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = word.find_first_of(separators);
        parts.push_back(word.substr(0, end));
        if (end == std::string_view::npos) {
            return parts;
        }
        word.remove_prefix(end + 1);
    }
}

}  // namespace balcony::app
