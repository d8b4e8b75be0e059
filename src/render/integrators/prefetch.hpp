// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace balcony::render {

/// Requests the memory of an object that is needed soon.
template <class T>
void prefetch(const T& object) {
    constexpr std::size_t cache_line = 64;
    for (std::size_t offset = 0; offset < sizeof(T); offset += cache_line) {
        __builtin_prefetch(reinterpret_cast<const char*>(&object) + offset);
    }
}

}  // namespace balcony::render
