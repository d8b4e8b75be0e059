// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>
#include <utility>

#include "balcony/progress.hpp"

namespace balcony::analyse {

/// Long work that can be told to stop, and says how far it is. By default it is never told to.
class Work {
public:
    /// Thrown where work is to stop. It does not leave the layer: see unless_stopped().
    struct Stopped {};

    Work() = default;
    Work(PartDone progress, std::stop_token stop)
        : progress_(std::move(progress)), stop_(std::move(stop)) {}

    /// To be called every few milliseconds. Throws if the work is to stop.
    void go_on() const {
        if (stop_.stop_requested()) {
            throw Stopped();
        }
    }
    /// The same where a part of the work is done, from 0 to 1.
    void done(double part) const {
        go_on();
        if (progress_) {
            progress_(part);
        }
    }
    [[nodiscard]] const std::stop_token& stop() const { return stop_; }
    /// Work that is a part of this.
    [[nodiscard]] Work part(double begin, double end) const {
        return {part_of(progress_, begin, end), stop_};
    }
    /// Work whose progress nobody sees.
    [[nodiscard]] Work silent() const { return {{}, stop_}; }

private:
    PartDone progress_;
    std::stop_token stop_;
};

/// What `make` gives, a result, or the error of work that was stopped.
template <class Make>
[[nodiscard]] auto unless_stopped(const Make& make) -> decltype(make()) {
    try {
        return make();
    } catch (const Work::Stopped&) {
        return stopped();
    }
}

}  // namespace balcony::analyse
