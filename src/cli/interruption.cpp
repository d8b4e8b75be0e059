// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/interruption.hpp"

#include <csignal>
#include <ctime>
#include <mutex>
#include <optional>

#include <unistd.h>

#include "cli/command.hpp"

namespace balcony::cli {

namespace {

std::mutex job_mutex;
std::optional<std::stop_source> job;

sigset_t watched_signals() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    sigaddset(&signals, SIGHUP);
    return signals;
}

void answer_signal() {
    const std::lock_guard lock(job_mutex);
    if (!job || !job->request_stop()) {
        _exit(static_cast<int>(ExitCode::interrupted));
    }
}

}  // namespace

Interruption::Interruption() {
    const sigset_t signals = watched_signals();
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    watcher_ = std::jthread([](const std::stop_token& done) {
        const sigset_t watched = watched_signals();
        const timespec wait{0, 50'000'000};
        while (!done.stop_requested()) {
            if (sigtimedwait(&watched, nullptr, &wait) > 0) {
                answer_signal();
            }
        }
    });
}

Interruption::~Interruption() = default;

std::stop_token Interruption::begin_job() {
    const std::lock_guard lock(job_mutex);
    job.emplace();
    return job->get_token();
}

void Interruption::end_job() {
    const std::lock_guard lock(job_mutex);
    job.reset();
}

}  // namespace balcony::cli
