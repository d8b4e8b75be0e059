// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>
#include <thread>

namespace balcony::cli {

/// Takes Ctrl-C, SIGTERM and SIGHUP away from all threads that are started later and answers them
/// on a thread of its own: a job that watches the token is asked to stop, without one, or at the
/// second signal, the process ends at once with exit code 130.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// The token of the job that runs now; there is one job at a time.
    [[nodiscard]] static std::stop_token begin_job();
    static void end_job();

private:
    std::jthread watcher_;
};

}  // namespace balcony::cli
