// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Frames become messages on a thread of their own: a view does not wait for it, and of frames that
// come faster the newest one counts.

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "balcony/live.hpp"
#include "studio/web/server.hpp"

namespace balcony::studio {

class FrameEncoder {
public:
    /// What is told comes from the thread, one call at a time.
    struct Told {
        std::function<void(Bytes)> frame;
        std::function<void(std::uint64_t)> rest;  ///< After its last frame.
    };

    explicit FrameEncoder(Told told);

    void show(const live::Frame& frame);
    void rest(std::uint64_t change);

private:
    void work(const std::stop_token& stop);

    Told told_;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<live::Frame> frame_;  // Guarded by the mutex, as is this.
    std::optional<std::uint64_t> rest_;
    std::jthread thread_;  // The last member, since it uses the others.
};

}  // namespace balcony::studio
