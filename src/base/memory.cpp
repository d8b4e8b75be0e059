// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "base/memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

namespace balcony {

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

double physical_memory() {
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
           static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace balcony
