// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "images/exif.hpp"

#include <cstddef>

#include "images/byte_numbers.hpp"

namespace balcony::images {

int exif_orientation(std::string_view exif) {
    constexpr std::size_t orientation = 0x0112;
    constexpr std::size_t a_short = 3;
    constexpr std::size_t entry_size = 12;
    constexpr int as_stored = 1;
    if (!exif.starts_with("II") && !exif.starts_with("MM")) {
        return as_stored;
    }
    const auto number = exif.starts_with("II") ? little_endian : big_endian;
    const std::size_t directory = number(exif, 4, 4);
    const std::size_t entries = number(exif, directory, 2);
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + i * entry_size;
        if (entry + entry_size > exif.size()) {
            break;
        }
        if (number(exif, entry, 2) == orientation && number(exif, entry + 2, 2) == a_short) {
            return static_cast<int>(number(exif, entry + 8, 2));
        }
    }
    return as_stored;
}

}  // namespace balcony::images
