// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/worker.hpp"

#include <utility>

#include "lsp/rpc.hpp"

namespace balcony::studio {

void Worker::give(Task task) {
    {
        const std::lock_guard lock(mutex_);
        if (tasks_.size() >= most_waiting) {
            throw lsp::Refusal{lsp::request_failed,
                               "the studio is busy with earlier questions: ask again later"};
        }
        tasks_.push_back(std::move(task));
    }
    changed_.notify_one();
}

void Worker::work(const std::stop_token& stop) {
    for (;;) {
        Task task;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, stop, [this] { return !tasks_.empty(); });
            if (stop.stop_requested()) {
                return;
            }
            task = std::move(tasks_.front());
            tasks_.pop_front();
        }
        task(stop);
    }
}

}  // namespace balcony::studio
