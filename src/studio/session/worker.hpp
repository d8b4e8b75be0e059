// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Work that takes too long for the thread of the server: done in order, on a thread of its own.

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace balcony::studio {

class Worker {
public:
    /// Work is given the token of the worker's end.
    using Task = std::function<void(const std::stop_token&)>;
    static constexpr std::size_t most_waiting = 64;

    Worker() : thread_([this](const std::stop_token& stop) { work(stop); }) {}

    /// Throws a Refusal if too much waits already.
    void give(Task task);

private:
    void work(const std::stop_token& stop);

    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Task> tasks_;  // Guarded by the mutex.
    std::jthread thread_;     // The last member, since it uses the others.
};

}  // namespace balcony::studio
