// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>

#include "balcony/app.hpp"
#include "cli/interruption.hpp"
#include "cli/report/answer.hpp"
#include "cli/report/progress_display.hpp"

namespace balcony::cli {

/// Shows on standard error what a render tells while it runs. A signal stops the render.
class RenderObserver {
public:
    explicit RenderObserver(const Manner& manner);

    [[nodiscard]] const app::Observer& observer() const { return observer_; }
    [[nodiscard]] std::stop_token token() const { return work_.token(); }
    void stop() { work_.stop(); }
    /// Makes place for other output.
    void clear() { display_.clear(); }

private:
    ProgressDisplay display_;
    Interruptible work_;
    app::Observer observer_;
};

}  // namespace balcony::cli
