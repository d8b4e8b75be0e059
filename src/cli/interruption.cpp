// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/interruption.hpp"

#include <csignal>
#include <mutex>

#include <unistd.h>

#include "cli/exit_code.hpp"

namespace balcony::cli {

namespace {

std::mutex job_mutex;
std::stop_source* job = nullptr;

// Asks the watcher to end.
int wake_signal() { return SIGRTMIN; }

bool is_ignored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

sigset_t watched_signals() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, wake_signal());
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        if (!is_ignored(signal)) {
            sigaddset(&signals, signal);
        }
    }
    return signals;
}

// On a terminal, keeps the current line and starts a new one for the prompt.
[[noreturn]] void end_at_once() {
    if (isatty(STDERR_FILENO) != 0) {
        [[maybe_unused]] const auto written = ::write(STDERR_FILENO, "\n", 1);
    }
    _exit(static_cast<int>(ExitCode::interrupted));
}

void answer_signal() {
    const std::lock_guard lock(job_mutex);
    if (job == nullptr || !job->request_stop()) {
        end_at_once();
    }
}

}  // namespace

Interruption::Interruption() {
    const sigset_t signals = watched_signals();
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    watcher_ = std::jthread([signals] {
        int signal = 0;
        while (sigwait(&signals, &signal) == 0 && signal != wake_signal()) {
            answer_signal();
        }
    });
}

Interruption::~Interruption() { pthread_kill(watcher_.native_handle(), wake_signal()); }

Interruptible::Interruptible() {
    const std::lock_guard lock(job_mutex);
    job = &stop_;
}

Interruptible::~Interruptible() {
    const std::lock_guard lock(job_mutex);
    job = nullptr;
}

}  // namespace balcony::cli
