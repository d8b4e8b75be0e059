// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace balcony {

/// The contents of an element of XML or HTML that are a text.
[[nodiscard]] inline std::string markup_of(std::string_view text) {
    std::string made;
    for (const char c : text) {
        made += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    }
    return made;
}

}  // namespace balcony
