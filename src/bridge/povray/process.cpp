// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/povray/process.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace balcony::bridge::povray {

namespace {

using Clock = std::chrono::steady_clock;

/// The two ends of a pipe, closed in programs that are started.
class Pipe {
public:
    Pipe() { open_ = pipe2(ends_.data(), O_CLOEXEC) == 0; }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        if (open_) {
            close(ends_[0]);
            close_input();
        }
    }

    [[nodiscard]] bool good() const { return open_; }
    [[nodiscard]] int output() const { return ends_[0]; }
    [[nodiscard]] int input() const { return ends_[1]; }
    void close_input() {
        if (ends_[1] >= 0) {
            close(ends_[1]);
            ends_[1] = -1;
        }
    }

private:
    std::array<int, 2> ends_{-1, -1};
    bool open_ = false;
};

/// What differs in a new program: its folder, streams and signals. Signals that this process blocks
/// or ignores are as usual there.
class StartActions {
public:
    StartActions(const Command& command, int output) {
        posix_spawn_file_actions_init(&files_);
        posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&files_, output, STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&files_, output, STDERR_FILENO);
        if (!command.folder.empty()) {
            posix_spawn_file_actions_addchdir_np(&files_, command.folder.c_str());
        }
        posix_spawnattr_init(&attributes_);
        sigset_t signals;
        sigemptyset(&signals);
        posix_spawnattr_setsigmask(&attributes_, &signals);
        sigaddset(&signals, SIGPIPE);
        sigaddset(&signals, SIGXFSZ);
        posix_spawnattr_setsigdefault(&attributes_, &signals);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    }
    StartActions(const StartActions&) = delete;
    StartActions& operator=(const StartActions&) = delete;
    ~StartActions() {
        posix_spawn_file_actions_destroy(&files_);
        posix_spawnattr_destroy(&attributes_);
    }

    [[nodiscard]] std::optional<pid_t> start(const Command& command) const {
        std::vector<std::string> words{command.program.string()};
        words.insert(words.end(), command.arguments.begin(), command.arguments.end());
        std::vector<char*> pointers;
        for (std::string& word : words) {
            pointers.push_back(word.data());
        }
        pointers.push_back(nullptr);
        pid_t process = 0;
        const int failed = posix_spawn(&process, command.program.c_str(), &files_, &attributes_,
                                       pointers.data(), environ);
        return failed == 0 ? std::optional(process) : std::nullopt;
    }

private:
    posix_spawn_file_actions_t files_{};
    posix_spawnattr_t attributes_{};
};

/// Asks a process to end, and later ends it by force.
class Ender {
public:
    explicit Ender(pid_t process) : process_(process) {}

    void ask() {
        constexpr std::chrono::seconds patience{2};
        const Clock::time_point now = Clock::now();
        if (!asked_) {
            asked_ = true;
            since_ = now;
            kill(process_, SIGTERM);
        } else if (now - since_ > patience) {
            kill(process_, SIGKILL);
        }
    }

private:
    pid_t process_;
    bool asked_ = false;
    Clock::time_point since_{};
};

}  // namespace

ProcessResult run_process(const Command& command, const std::function<void(std::string_view)>& show,
                          const std::stop_token& stop) {
    ProcessResult result;
    Pipe pipe;
    if (!pipe.good()) {
        return result;
    }
    const std::optional<pid_t> process = StartActions(command, pipe.input()).start(command);
    pipe.close_input();
    if (!process) {
        return result;
    }
    Ender ender(*process);
    std::array<char, 65536> buffer{};
    for (bool open = true; open;) {
        if (stop.stop_requested()) {
            ender.ask();
        }
        constexpr int milliseconds = 50;
        pollfd output{pipe.output(), POLLIN, 0};
        if (poll(&output, 1, milliseconds) <= 0) {
            continue;
        }
        const ssize_t count = read(pipe.output(), buffer.data(), buffer.size());
        open = count > 0 || (count < 0 && errno == EINTR);
        if (count > 0) {
            const std::string_view part(buffer.data(), static_cast<std::size_t>(count));
            result.output += part;
            if (show) {
                show(part);
            }
        }
    }
    int status = 0;
    while (waitpid(*process, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFEXITED(status)) {
        result.exit_code = WEXITSTATUS(status);
    }
    return result;
}

}  // namespace balcony::bridge::povray
