// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace balcony::scene {

using Triple = std::array<std::uint32_t, 3>;

/// Numbers distinct triples from 0, in the order in which they first occur: a hash table with open
/// addressing, since a scene has millions of them.
class TripleNumbers {
public:
    [[nodiscard]] std::uint32_t number(const Triple& triple) {
        if (2 * triples_.size() >= slots_.size()) {
            grow();
        }
        std::uint32_t& slot = slot_of(triple);
        if (slot == empty) {
            slot = static_cast<std::uint32_t>(triples_.size());
            triples_.push_back(triple);
        }
        return slot;
    }

    /// By number.
    [[nodiscard]] const std::vector<Triple>& triples() const { return triples_; }

private:
    static constexpr std::uint32_t empty = 0xffffffffU;

    // Multiplication and a shift, as in the finaliser of MurmurHash3.
    static std::uint64_t mixed(std::uint64_t hash, std::uint32_t next) {
        hash = (hash ^ next) * 0xff51afd7ed558ccdU;
        return hash ^ hash >> 32U;
    }

    // The slot that has the triple, or the empty one for it.
    std::uint32_t& slot_of(const Triple& triple) {
        const std::size_t mask = slots_.size() - 1;
        auto place = static_cast<std::size_t>(
            mixed(mixed(mixed(0x9e3779b97f4a7c15U, triple[0]), triple[1]), triple[2]));
        while (slots_[place & mask] != empty && triples_[slots_[place & mask]] != triple) {
            ++place;
        }
        return slots_[place & mask];
    }

    void grow() {
        constexpr std::size_t smallest = 16;
        slots_.assign(slots_.empty() ? smallest : 2 * slots_.size(), empty);
        for (std::uint32_t number = 0; number < triples_.size(); ++number) {
            slot_of(triples_[number]) = number;
        }
    }

    std::vector<Triple> triples_;
    std::vector<std::uint32_t> slots_;  // Numbers; their count is a power of two.
};

}  // namespace balcony::scene
