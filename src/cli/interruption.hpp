// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>
#include <thread>

namespace balcony::cli {

/// Takes Ctrl-C, SIGTERM and SIGHUP away from all threads that are started later and answers them
/// on a thread of its own: a job that watches the token is asked to stop; without one, or at the
/// second signal, the process ends at once with exit code 130. A signal that whoever started the
/// process wants ignored (nohup) stays ignored.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

private:
    std::jthread watcher_;
};

/// What a first signal asks to stop, from making to destruction; there is one at a time.
class Job {
public:
    Job();
    ~Job();
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

    [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }

private:
    std::stop_source stop_;
};

}  // namespace balcony::cli
