// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace balcony::images {

/// The bytes of an image file: its own, or those of somebody who keeps them longer.
class EncodedBytes {
public:
    explicit EncodedBytes(std::vector<std::uint8_t> own) : own_(std::move(own)), bytes_(own_) {}
    explicit EncodedBytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
    EncodedBytes(EncodedBytes&&) noexcept = default;
    EncodedBytes& operator=(EncodedBytes&&) noexcept = default;
    EncodedBytes(const EncodedBytes&) = delete;
    EncodedBytes& operator=(const EncodedBytes&) = delete;
    ~EncodedBytes() = default;

    [[nodiscard]] std::span<const std::uint8_t> span() const { return bytes_; }
    [[nodiscard]] std::string_view text() const { return as_text(bytes_); }

    [[nodiscard]] static std::string_view as_text(std::span<const std::uint8_t> bytes) {
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }

private:
    std::vector<std::uint8_t> own_;  // Its elements do not move with it.
    std::span<const std::uint8_t> bytes_;
};

}  // namespace balcony::images
