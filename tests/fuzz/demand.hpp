// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How a fuzzer ends when a promise is broken.

#include <cstdio>
#include <cstdlib>
#include <string>

namespace balcony {

inline void demand(bool holds, const char* what) {
    if (!holds) {
        std::fprintf(stderr, "%s\n", what);
        std::abort();
    }
}

/// What a law says when it is broken; empty if it holds.
inline void demand_no(const std::string& broken) { demand(broken.empty(), broken.c_str()); }

}  // namespace balcony
