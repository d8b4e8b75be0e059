// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/words.hpp"

#include <charconv>
#include <system_error>

namespace balcony::app {

std::optional<std::size_t> whole_number_of(std::string_view text) {
    std::size_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [read_to, failed] = std::from_chars(text.data(), end, number);
    return failed == std::errc() && read_to == end ? std::optional(number) : std::nullopt;
}

bool add(Diagnostics& diagnostics, const Diagnostics& more) {
    diagnostics.insert(diagnostics.end(), more.begin(), more.end());
    return has_errors(more);
}

}  // namespace balcony::app
