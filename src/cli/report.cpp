// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report.hpp"

#include <cmath>

#include <fmt/format.h>

namespace balcony::cli {

void report(const Diagnostics& diagnostics) { fmt::print(stderr, "{}", to_text(diagnostics)); }

std::string count_text(double count) {
    if (count < 1e4) {
        return fmt::format("{:.0f}", count);
    }
    const bool thousands = count < 1e6;
    const bool millions = count < 1e9;
    return thousands  ? fmt::format("{:.1f} k", count / 1e3)
           : millions ? fmt::format("{:.1f} M", count / 1e6)
                      : fmt::format("{:.1f} G", count / 1e9);
}

std::string duration_text(double seconds) {
    if (seconds < 60.0) {
        return fmt::format("{:.1f} s", seconds);
    }
    const auto whole = static_cast<long>(std::lround(seconds));
    if (whole < 3600) {
        return fmt::format("{}:{:02} min", whole / 60, whole % 60);
    }
    return fmt::format("{}:{:02} h", whole / 3600, whole % 3600 / 60);
}

}  // namespace balcony::cli
