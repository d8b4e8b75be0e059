// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/picture/paused_run.hpp"

#include <algorithm>
#include <limits>

#include "app/words.hpp"
#include "balcony/bands.hpp"
#include "balcony/shard.hpp"

namespace balcony::app {

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

void tell(const Observer& observer, const Diagnostics& diagnostics) {
    if (observer.tell && !diagnostics.empty()) {
        observer.tell(diagnostics);
    }
}

Result<render::Summary> trace(render::Job& job, const render::Film& film,
                              const CheckpointFile& checkpoint, TraceLimits limits,
                              const render::ProgressCallback& progress,
                              const std::stop_token& stop) {
    if (limits.checkpoint_every) {
        limits.pauses.push_back({*limits.checkpoint_every, limits.save_checkpoint});
    }
    const std::vector<std::uint32_t> passes =
        limits.shard
            ? render::passes_of(film, *limits.shard, static_cast<std::uint32_t>(limits.samples))
            : std::vector<std::uint32_t>{};
    Result<render::Summary> total{render::Summary{}};
    const Clock::time_point begin = Clock::now();
    std::vector<double> due;  // Of each pause, in seconds since the beginning.
    for (const Pause& pause : limits.pauses) {
        due.push_back(pause.seconds);
    }
    if (limits.checkpoint_every) {
        due.back() = std::max(due.back() - limits.since_checkpoint, 0.0);
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
        Result<render::Summary> part = passes.empty()
                                           ? job.run(on_progress, pause.get_token())
                                           : job.run(passes, on_progress, pause.get_token());
        add(total.diagnostics, part.diagnostics);
        if (!part) {
            return std::move(total.diagnostics);
        }
        render::add(*total, *part);
        tiles_done += done_now;
        const double now = seconds_since(begin);
        if (!part->interrupted) {
            return total;
        }
        if (stop.stop_requested()) {
            if (part.diagnostics.empty() &&
                (limits.begins_checkpoint_at_stop || checkpoint.is_used())) {
                limits.save_checkpoint();
            }
            return total;
        }
        if (!part.diagnostics.empty() && checkpoint.is_used()) {
            total.diagnostics.push_back(
                error(Kind::environment, "a texture cannot be read any more, so the render ends",
                      limits.remedy));
            return std::move(total.diagnostics);
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

}  // namespace balcony::app
