// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace balcony::page {

/// The bytes of a page: arrays one after another, each from a multiple of four on, with the lowest
/// byte of a number first.
class Blob {
public:
    /// Returns where the array begins.
    template <class T>
    std::size_t add(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        return add_bytes(
            {reinterpret_cast<const std::uint8_t*>(values.data()), values.size_bytes()});
    }
    std::size_t add_bytes(std::span<const std::uint8_t> bytes);

    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    [[nodiscard]] std::string base64() const;

private:
    std::vector<std::uint8_t> bytes_;
};

}  // namespace balcony::page
