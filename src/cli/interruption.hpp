// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>
#include <thread>

namespace balcony::cli {

/// Blocks SIGINT (Ctrl-C), SIGTERM and SIGHUP in all threads started later and handles them on a
/// separate thread. The first signal asks a job that watches the token to stop. Without such a job,
/// and at the second signal, the process ends at once with exit code 130. Signals that the parent
/// process ignores (nohup) remain ignored.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

private:
    std::jthread watcher_;
};

/// During its lifetime, the first signal requests a stop through it. Only one may exist at a time.
class Interruptible {
public:
    Interruptible();
    ~Interruptible();
    Interruptible(const Interruptible&) = delete;
    Interruptible& operator=(const Interruptible&) = delete;

    [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }
    void stop() { stop_.request_stop(); }

private:
    std::stop_source stop_;
};

}  // namespace balcony::cli
