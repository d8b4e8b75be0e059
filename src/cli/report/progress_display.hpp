// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
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

    /// From now on, the progress is that of one of several frames, which all take equally long.
    void begin_frame(std::size_t frame, std::size_t index, std::size_t count);
    void show(const render::Progress& progress);
    /// The part of a step before the render, on a terminal.
    void show_step(const std::string& step, double part);
    /// Another text, on a terminal.
    void show_text(const std::string& text);
    /// Makes place for other output.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    void show_bar(double done, const std::string& state);
    void show_line(double done, double seconds, const std::string& state);

    struct Frames {
        std::size_t frame = 0;
        std::size_t index = 0;
        std::size_t count = 1;
    };

    bool quiet_;
    bool terminal_;
    bool bar_shown_ = false;
    Clock::time_point last_shown_{};
    int tenths_shown_ = 0;
    std::optional<Frames> frames_;
    Clock::time_point begin_ = Clock::now();
};

}  // namespace balcony::cli
