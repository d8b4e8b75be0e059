// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/progress_display.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

constexpr auto shortest_interval = std::chrono::milliseconds(100);
constexpr int bar_width = 30;

bool is_terminal() {
    const char* kind = std::getenv("TERM");
    return isatty(STDERR_FILENO) != 0 && std::string_view(kind != nullptr ? kind : "") != "dumb";
}

std::size_t terminal_width() {
    constexpr std::size_t usual = 80;
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual;
}

std::string time_left(double done, double seconds) {
    constexpr double too_early_to_tell = 0.5;
    if (seconds < too_early_to_tell || done <= 0.0) {
        return {};
    }
    return fmt::format(", {} left", duration_text(seconds * (1.0 - done) / done));
}

}  // namespace

ProgressDisplay::ProgressDisplay(bool quiet) : quiet_(quiet), terminal_(is_terminal()) {}

ProgressDisplay::~ProgressDisplay() { clear(); }

void ProgressDisplay::clear() {
    if (bar_shown_) {
        show_status("");
        bar_shown_ = false;
    }
}

void ProgressDisplay::begin_frame(std::size_t frame, std::size_t index, std::size_t count) {
    frames_ = Frames{frame, index, count};
}

void ProgressDisplay::show(const render::Progress& progress) {
    if (quiet_ || progress.tiles == 0) {
        return;
    }
    double done = static_cast<double>(progress.tiles_done) / static_cast<double>(progress.tiles);
    double seconds = progress.seconds;
    std::string what = fmt::format("pass {} of {}", progress.pass + 1, progress.passes);
    if (frames_) {
        done = (static_cast<double>(frames_->index) + done) / static_cast<double>(frames_->count);
        seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
        what =
            fmt::format("frame {} ({} of {})", frames_->frame, frames_->index + 1, frames_->count);
    }
    const std::string state =
        fmt::format("{:3.0f} %, {}{}", 100.0 * done, what, time_left(done, seconds));
    if (terminal_) {
        show_bar(done, state);
    } else {
        show_line(done, seconds, state);
    }
}

// Most steps are over at once.
void ProgressDisplay::show_step(const std::string& step, double part) {
    constexpr auto long_enough = std::chrono::milliseconds(300);
    if (!quiet_ && terminal_ && Clock::now() - begin_ >= long_enough) {
        show_bar(part, fmt::format("{:3.0f} %, {}", 100.0 * part, step));
    }
}

void ProgressDisplay::show_text(const std::string& text) {
    if (!quiet_ && terminal_) {
        show_status(text.substr(0, terminal_width() - 1));
        bar_shown_ = true;
    }
}

// Narrower than the terminal, so that it does not wrap.
void ProgressDisplay::show_bar(double done, const std::string& state) {
    const auto now = Clock::now();
    if (now - last_shown_ < shortest_interval) {
        return;
    }
    last_shown_ = now;
    bar_shown_ = true;
    const int filled = std::clamp(static_cast<int>(done * bar_width), 0, bar_width);
    std::string line = fmt::format("[{:#<{}}{:{}}] {}", "", filled, "", bar_width - filled, state);
    const std::size_t room = terminal_width() - 1;
    if (line.size() > room) {
        line = state.substr(0, room);
    }
    show_status(line);
}

void ProgressDisplay::show_line(double done, double seconds, const std::string& state) {
    constexpr double short_enough_to_wait = 1.0;
    const int tenths = static_cast<int>(done * 10.0);
    if (tenths > tenths_shown_ && seconds >= short_enough_to_wait) {
        tenths_shown_ = tenths;
        print_aside(state + "\n");
    }
}

}  // namespace balcony::cli
