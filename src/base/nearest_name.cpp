// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include "balcony/base.hpp"

namespace balcony {

namespace {

bool same_letter(char a, char b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    return lower(a) == lower(b);
}

// The number of insertions, deletions, replacements and swaps of neighbours between two names
// (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before_last(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) {
        last[j] = j;
    }
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (same_letter(a[i - 1], b[j - 1]) ? 0 : 1);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) &&
                same_letter(a[i - 2], b[j - 1])) {
                row[j] = std::min(row[j], before_last[j - 2] + 1);
            }
        }
        std::swap(before_last, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view name,
                                        const std::vector<std::string>& candidates) {
    constexpr std::size_t max_sensible_name = 64;
    if (name.empty() || name.size() > max_sensible_name) {
        return std::nullopt;
    }
    std::optional<std::string> nearest;
    std::size_t minimum = (name.size() == 2 ? 1 : name.size() / 3) + 1;
    for (const std::string& candidate : candidates) {
        // The distance is at least the difference of the lengths.
        if (candidate.size() >= name.size() + minimum) {
            continue;
        }
        const std::size_t distance = edit_distance(name, candidate);
        if (distance < minimum) {
            minimum = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

}  // namespace balcony
