// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Median: the middle value of sorted numbers.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace balcony {

/// The middle number, or the mean of the two in the middle; nothing of no numbers. None may be NaN.
[[nodiscard]] inline std::optional<double> median(std::vector<double> numbers) {
    if (numbers.empty()) {
        return std::nullopt;
    }
    const auto upper = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
    std::nth_element(numbers.begin(), upper, numbers.end());
    if (numbers.size() % 2 == 1) {
        return *upper;
    }
    // Halved first, as the sum of two large numbers may not be one.
    return 0.5 * *std::max_element(numbers.begin(), upper) + 0.5 * *upper;
}

}  // namespace balcony
