// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The values of ImageFile::read_rows() from those of a file, by the rules of OpenImageIO.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>

namespace balcony::images {

template <class To, class From>
[[nodiscard]] To sample_value(From value) {
    if constexpr (std::is_same_v<To, From>) {
        return value;
    } else if constexpr (std::is_same_v<To, float>) {
        return static_cast<float>(value) *
               (1.0F / static_cast<float>(std::numeric_limits<From>::max()));
    } else {
        constexpr float largest = std::numeric_limits<To>::max();
        const float scaled = sample_value<float>(value) * largest;
        // What is no number is 0.
        return static_cast<To>((scaled > 0.0F ? std::min(scaled, largest) : 0.0F) + 0.5F);
    }
}

template <class From, class To>
void copy_samples(std::span<const From> from, std::span<To> to) {
    std::transform(from.begin(), from.end(), to.begin(), sample_value<To, From>);
}

}  // namespace balcony::images
