// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>

#include "balcony/render.hpp"

namespace balcony::cli {

/// Shows the progress of a render on standard error. On a terminal, this is a bar with the time
/// left; otherwise, renders that take more than a second print a line per 10 %.
class ProgressDisplay {
public:
    explicit ProgressDisplay(bool quiet);
    ~ProgressDisplay();
    ProgressDisplay(const ProgressDisplay&) = delete;
    ProgressDisplay& operator=(const ProgressDisplay&) = delete;

    void show(const render::Progress& progress);
    /// Makes place for other output.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    void show_bar(double done, const std::string& state);
    void show_line(double done, double seconds, const std::string& state);

    bool quiet_;
    bool terminal_;
    bool bar_shown_ = false;
    Clock::time_point last_shown_{};
    int tenths_shown_ = 0;
};

}  // namespace balcony::cli
