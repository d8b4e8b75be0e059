// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A render that pauses to save what it has.

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "balcony/render.hpp"

namespace balcony::cli {

/// Something to do at an interval. `act` runs while the film is at rest.
struct Pause {
    double seconds = 0.0;
    std::function<void()> act;
    std::optional<double> first{};  ///< The seconds until the first time, if these are others.
};

/// The limits of a run.
struct RunLimits {
    /// Of tracing. The first pass is completed in any case.
    std::optional<double> seconds;
    /// Asked at each pause, with the warnings since the last one; true ends the run.
    std::function<bool(const Diagnostics&)> gives_up;
    std::vector<Pause> pauses;
    /// The number of passes that each tile gets; those of the job's settings if empty.
    std::vector<std::uint32_t> passes{};
};

/// Runs a job to its end, with pauses. The summary is that of the whole run; it is not interrupted
/// if the time was up.
[[nodiscard]] Result<render::Summary> run_with_pauses(render::Job& job, const RunLimits& limits,
                                                      const render::ProgressCallback& progress,
                                                      const std::stop_token& stop);

}  // namespace balcony::cli
