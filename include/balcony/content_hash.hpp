// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Notices that bytes have changed or were damaged. Not secure against forgery.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

namespace balcony {

/// A 64-bit hash of a sequence of blocks: MurmurHash64A (Appleby), each block with the hash of
/// those before it as its seed.
class ContentHash {
public:
    void add(std::span<const std::byte> block);
    [[nodiscard]] std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0;
};

/// The hash of a file's bytes; nothing if it cannot be read.
[[nodiscard]] std::optional<std::uint64_t> content_hash(const std::filesystem::path& file);

}  // namespace balcony
