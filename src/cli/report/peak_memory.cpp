// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/peak_memory.hpp"

#include <sys/resource.h>

namespace balcony::cli {

std::uint64_t peak_memory() {
    rusage usage{};
    if (getrusage(RUSAGE_SELF, &usage) != 0) {
        return 0;
    }
#if defined(__APPLE__)
    constexpr std::uint64_t unit = 1;
#else
    constexpr std::uint64_t unit = 1024;
#endif
    return unit * static_cast<std::uint64_t>(usage.ru_maxrss);
}

}  // namespace balcony::cli
