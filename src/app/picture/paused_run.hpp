// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A render that pauses to save what it has.

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "app/picture/checkpoint_file.hpp"
#include "balcony/app.hpp"
#include "balcony/render.hpp"

namespace balcony::app {

/// Something to do at an interval. `act` runs while the film is at rest.
struct Pause {
    double seconds = 0.0;
    std::function<void()> act;
    std::optional<double> first{};  ///< The seconds until the first time, if these are others.
};

/// How a film is traced.
struct TraceLimits {
    /// Of tracing. The first pass is completed in any case.
    std::optional<double> seconds{};
    std::vector<Pause> pauses{};
    std::optional<render::Shard> shard{};  ///< The part of the passes, of all `samples`.
    std::size_t samples = 0;
    /// What the user can do if a texture vanishes.
    std::string remedy{};
};

/// Runs a job to its end, its time or a stop, with pauses. The summary is that of the whole run; it
/// is interrupted by nothing but a stop. A texture that vanishes after a checkpoint would spoil the
/// picture, so that it is an error.
[[nodiscard]] Result<render::Summary> trace(render::Job& job, const render::Film& film,
                                            const CheckpointFile& checkpoint,
                                            const TraceLimits& limits,
                                            const render::ProgressCallback& progress,
                                            const std::stop_token& stop);

/// Tells at once, if anybody listens.
void tell(const Observer& observer, const Diagnostics& diagnostics);

/// While it lives, a stop is obeyed.
class Stoppable {
public:
    explicit Stoppable(const Observer& observer) : observer_(observer) { say(true); }
    ~Stoppable() { say(false); }
    Stoppable(const Stoppable&) = delete;
    Stoppable& operator=(const Stoppable&) = delete;

private:
    void say(bool obeyed) const {
        if (observer_.stoppable) {
            observer_.stoppable(obeyed);
        }
    }
    const Observer& observer_;
};

}  // namespace balcony::app
