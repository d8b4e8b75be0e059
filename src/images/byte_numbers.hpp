// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Unsigned numbers in the bytes of a file.

#include <cstddef>
#include <string_view>

namespace balcony::images {

/// The number of `count` bytes at an offset, of which the first is the highest; 0 if they are not
/// all there.
[[nodiscard]] constexpr std::size_t big_endian(std::string_view bytes, std::size_t offset,
                                               std::size_t count) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < count && offset + count <= bytes.size(); ++i) {
        number = number << 8U | static_cast<unsigned char>(bytes[offset + i]);
    }
    return number;
}

/// The same if the first byte is the lowest.
[[nodiscard]] constexpr std::size_t little_endian(std::string_view bytes, std::size_t offset,
                                                  std::size_t count) {
    std::size_t number = 0;
    for (std::size_t i = count; i > 0 && offset + count <= bytes.size(); --i) {
        number = number << 8U | static_cast<unsigned char>(bytes[offset + i - 1]);
    }
    return number;
}

/// Whether a text stands at an offset.
[[nodiscard]] constexpr bool has(std::string_view bytes, std::size_t offset,
                                 std::string_view text) {
    return offset <= bytes.size() && bytes.substr(offset).starts_with(text);
}

}  // namespace balcony::images
