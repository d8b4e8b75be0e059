// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/content_hash.hpp"

#include <cstring>
#include <fstream>
#include <vector>

#include "balcony/input_file.hpp"

namespace balcony {

void ContentHash::add(std::span<const std::byte> block) {
    constexpr std::uint64_t factor = 0xc6a4a7935bd1e995U;
    constexpr int shift = 47;
    std::uint64_t hash = value_ ^ (block.size() * factor);
    const auto mix = [&](std::uint64_t word) {
        word *= factor;
        word ^= word >> shift;
        hash = (hash ^ word * factor) * factor;
    };
    std::size_t at = 0;
    for (; at + sizeof(std::uint64_t) <= block.size(); at += sizeof(std::uint64_t)) {
        std::uint64_t word = 0;
        std::memcpy(&word, block.data() + at, sizeof word);
        mix(word);
    }
    if (at < block.size()) {
        std::uint64_t word = 0;
        std::memcpy(&word, block.data() + at, block.size() - at);
        mix(word);
    }
    hash = (hash ^ hash >> shift) * factor;
    value_ = hash ^ hash >> shift;
}

std::optional<std::uint64_t> content_hash(const std::filesystem::path& file) {
    if (not_a_file(file, "")) {
        return std::nullopt;
    }
    std::ifstream stream(file, std::ios::binary);
    std::vector<std::byte> block(std::size_t{1} << 20);
    ContentHash hash;
    while (stream) {
        stream.read(reinterpret_cast<char*>(block.data()),
                    static_cast<std::streamsize>(block.size()));
        hash.add(std::span(block).first(static_cast<std::size_t>(stream.gcount())));
    }
    return stream.eof() ? std::optional(hash.value()) : std::nullopt;
}

}  // namespace balcony
