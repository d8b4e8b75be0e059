// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/progress_display.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "cli/report.hpp"

namespace balcony::cli {

namespace {

constexpr auto shortest_interval = std::chrono::milliseconds(100);
constexpr int bar_width = 30;

std::string time_left(double done, double seconds) {
    constexpr double too_early_to_tell = 0.5;
    if (seconds < too_early_to_tell || done <= 0.0) {
        return {};
    }
    return fmt::format(", {} left", duration_text(seconds * (1.0 - done) / done));
}

}  // namespace

ProgressDisplay::ProgressDisplay(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressDisplay::~ProgressDisplay() {
    if (bar_shown_) {
        fmt::print(stderr, "\r\033[K");
    }
}

void ProgressDisplay::show(const render::Progress& progress) {
    if (quiet_ || progress.tiles == 0) {
        return;
    }
    const double done =
        static_cast<double>(progress.tiles_done) / static_cast<double>(progress.tiles);
    const std::string state =
        fmt::format("{:3.0f} %, pass {} of {}{}", 100.0 * done, progress.pass + 1, progress.passes,
                    time_left(done, progress.seconds));
    if (terminal_) {
        const auto now = Clock::now();
        if (now - last_shown_ < shortest_interval) {
            return;
        }
        last_shown_ = now;
        bar_shown_ = true;
        const int filled = static_cast<int>(done * bar_width);
        fmt::print(stderr, "\r[{:#<{}}{:{}}] {}\033[K", "", filled, "", bar_width - filled, state);
        std::fflush(stderr);
        return;
    }
    const int tenths = static_cast<int>(done * 10.0);
    if (tenths > tenths_shown_) {
        tenths_shown_ = tenths;
        fmt::print(stderr, "{}\n", state);
    }
}

}  // namespace balcony::cli
