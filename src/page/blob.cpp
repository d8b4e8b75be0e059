// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "page/blob.hpp"

#include <algorithm>
#include <bit>
#include <string_view>

namespace balcony::page {

static_assert(std::endian::native == std::endian::little);

std::size_t Blob::add_bytes(std::span<const std::uint8_t> bytes) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    const std::size_t begin = bytes_.size();
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return begin;
}

std::string Blob::base64() const {
    static constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes_.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes_.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes_.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8U | (k < count ? bytes_[i + k] : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += k <= count ? digits[group >> (18U - 6U * k) & 63U] : '=';
        }
    }
    return text;
}

}  // namespace balcony::page
