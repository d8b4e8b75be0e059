// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/paused_run.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "balcony/bands.hpp"

namespace balcony::cli {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

Result<render::Summary> run_with_pauses(render::Job& job, const RunLimits& limits,
                                        const render::ProgressCallback& progress,
                                        const std::stop_token& stop) {
    Result<render::Summary> total{render::Summary{}};
    const Clock::time_point begin = Clock::now();
    std::vector<double> due;  // Of each pause, in seconds since the beginning.
    for (const Pause& pause : limits.pauses) {
        due.push_back(pause.first.value_or(pause.seconds));
    }
    const double end = limits.seconds.value_or(std::numeric_limits<double>::infinity());
    std::size_t tiles = 0;
    std::size_t tiles_done = 0;
    for (;;) {
        const double next =
            due.empty() ? end : std::min(end, *std::min_element(due.begin(), due.end()));
        std::stop_source pause;
        const std::stop_callback forward(stop, [&pause] { pause.request_stop(); });
        std::size_t done_now = 0;
        const auto on_progress = [&](render::Progress state) {
            done_now = state.tiles_done;
            tiles = std::max(tiles, tiles_done + state.tiles);
            state.tiles_done += tiles_done;
            state.tiles = tiles;
            state.seconds = seconds_since(begin);
            if (progress) {
                progress(state);
            }
            // A picture has at least one sample per pixel.
            if (state.seconds >= next && (next < end || state.pass > 0)) {
                pause.request_stop();
            }
        };
        Result<render::Summary> part = limits.passes.empty()
                                           ? job.run(on_progress, pause.get_token())
                                           : job.run(limits.passes, on_progress, pause.get_token());
        total.diagnostics.insert(total.diagnostics.end(), part.diagnostics.begin(),
                                 part.diagnostics.end());
        if (!part) {
            return std::move(total.diagnostics);
        }
        render::add(*total, *part);
        tiles_done += done_now;
        const double now = seconds_since(begin);
        if (!part->interrupted || stop.stop_requested() ||
            (limits.gives_up && limits.gives_up(part.diagnostics))) {
            return total;
        }
        if (now >= end && part->passes > 0) {
            total->interrupted = false;
            return total;
        }
        for (std::size_t i = 0; i < due.size(); ++i) {
            if (now >= due[i]) {
                limits.pauses[i].act();
                due[i] = seconds_since(begin) + limits.pauses[i].seconds;
            }
        }
    }
}

}  // namespace balcony::cli
