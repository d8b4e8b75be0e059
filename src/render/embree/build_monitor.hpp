// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <stop_token>
#include <utility>

#include "base/shared_progress.hpp"
#include "render/embree/rtcore.hpp"

namespace balcony::render::embree {

/// Who waits for a structure that is built in parts: told how far it is, and may stop it.
class BuildMonitor {
public:
    /// `size` is the sum of the sizes of all parts. The function must outlive the monitor.
    BuildMonitor(std::stop_token stop, const PartDone& progress, std::size_t size)
        : stop_(std::move(stop)), progress_(progress), size_(std::max<std::size_t>(size, 1)) {}

    [[nodiscard]] bool is_stopped() const { return stop_.stop_requested(); }

    /// Builds a part, unless a stop is requested; then, it is of no use.
    void commit(RTCScene part, std::size_t size) {
        if (is_stopped()) {
            return;
        }
        part_ = size;
        rtcSetSceneProgressMonitorFunction(part, watch, this);
        rtcCommitScene(part);
        rtcSetSceneProgressMonitorFunction(part, nullptr, nullptr);
        done_ += size;
    }

private:
    // Called by Embree's threads, with a part that may exceed 1.
    static bool watch(void* monitor, double part) {
        auto* const self = static_cast<BuildMonitor*>(monitor);
        const double done = static_cast<double>(self->done_) +
                            std::min(part, 1.0) * static_cast<double>(self->part_);
        self->progress_.reach(std::min(1.0, done / static_cast<double>(self->size_)));
        return !self->is_stopped();
    }

    std::stop_token stop_;
    SharedProgress progress_;
    std::size_t size_;
    std::size_t done_ = 0;
    std::size_t part_ = 0;
};

}  // namespace balcony::render::embree
