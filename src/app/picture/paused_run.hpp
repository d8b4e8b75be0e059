// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A render that pauses to save what it has.

#include <chrono>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "app/picture/checkpoint_file.hpp"
#include "balcony/app.hpp"
#include "balcony/render.hpp"

namespace balcony::app {

/// Something to do at an interval, while the film is at rest.
struct Pause {
    double seconds = 0.0;
    std::function<void()> act;
};

/// How a film is traced.
struct TraceLimits {
    /// Of tracing. The first pass is completed in any case.
    std::optional<double> seconds{};
    std::vector<Pause> pauses{};
    std::optional<double> checkpoint_every{};
    std::function<void()> save_checkpoint{};  ///< At this interval, and at a stop.
    bool begins_checkpoint_at_stop = true;    ///< Otherwise only if there is one before.
    double since_checkpoint = 0.0;            ///< The seconds since it was saved before.
    std::optional<render::Shard> shard{};     ///< The part of the passes, of all `samples`.
    std::size_t samples = 0;
    /// What the user can do if a texture vanishes.
    std::string remedy{};
};

/// Runs a job to its end, its time or a stop, with pauses. The summary is that of the whole run; it
/// is interrupted by nothing but a stop. A texture that vanishes after a checkpoint would spoil the
/// picture, so that it is an error.
[[nodiscard]] Result<render::Summary> trace(render::Job& job, const render::Film& film,
                                            const CheckpointFile& checkpoint, TraceLimits limits,
                                            const render::ProgressCallback& progress,
                                            const std::stop_token& stop);

/// Tells at once, if anybody listens.
void tell(const Observer& observer, const Diagnostics& diagnostics);

/// The seconds since a time.
using Clock = std::chrono::steady_clock;
[[nodiscard]] double seconds_since(Clock::time_point begin);

}  // namespace balcony::app
