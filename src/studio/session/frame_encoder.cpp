// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/frame_encoder.hpp"

#include <memory>
#include <utility>

#include "studio/session/frame_message.hpp"

namespace balcony::studio {

FrameEncoder::FrameEncoder(Told told)
    : told_(std::move(told)), thread_([this](const std::stop_token& stop) { work(stop); }) {}

void FrameEncoder::show(const live::Frame& frame) {
    {
        const std::lock_guard lock(mutex_);
        frame_ = frame;
        rest_.reset();
    }
    changed_.notify_one();
}

void FrameEncoder::rest(std::uint64_t change) {
    {
        const std::lock_guard lock(mutex_);
        rest_ = change;
    }
    changed_.notify_one();
}

void FrameEncoder::work(const std::stop_token& stop) {
    for (;;) {
        std::optional<live::Frame> frame;
        std::optional<std::uint64_t> rest;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, stop, [this] { return frame_ || rest_; });
            if (stop.stop_requested()) {
                return;
            }
            frame = std::exchange(frame_, std::nullopt);
            rest = std::exchange(rest_, std::nullopt);
        }
        if (frame) {
            told_.frame(std::make_shared<const std::vector<std::uint8_t>>(frame_message(*frame)));
        }
        if (rest) {
            told_.rest(*rest);
        }
    }
}

}  // namespace balcony::studio
