// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// An order of rays in which neighbours are similar, so that tracing one after the other finds in
// the cache what the ray before has used.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <Imath/ImathVec.h>

namespace balcony::render {

/// Sorts rays by the octant of their direction, then by the place of their origin along a Morton
/// curve through the box of all origins. Keeps its memory between calls.
class RayOrder {
public:
    struct Key {
        Imath::V3f origin;
        Imath::V3f direction;
    };

    /// The indices of the keys in order. Equal rays stay in the order in which they came. Valid
    /// until the next call.
    [[nodiscard]] std::span<const std::uint32_t> sort(std::span<const Key> rays);

private:
    std::vector<std::uint16_t> buckets_;  // By ray.
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> buffer_;
};

/// Sorts indices by the number, below `bucket_count`, that a function gives for each. Equal ones
/// stay in their order. `buffer` is kept for its memory.
template <std::uint32_t bucket_count, class Bucket>
void counting_sort(std::vector<std::uint32_t>& indices, std::vector<std::uint32_t>& buffer,
                   const Bucket& bucket) {
    std::array<std::uint32_t, bucket_count> starts{};
    for (const std::uint32_t i : indices) {
        ++starts[bucket(i)];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& start : starts) {
        start = std::exchange(sum, sum + start);
    }
    buffer.resize(indices.size());
    for (const std::uint32_t i : indices) {
        buffer[starts[bucket(i)]++] = i;
    }
    indices.swap(buffer);
}

}  // namespace balcony::render
