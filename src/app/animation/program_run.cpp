// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/animation/program_run.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <memory>
#include <optional>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace balcony::app {

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
// Without a name, so that nothing is left behind.
using ScratchFile = std::unique_ptr<std::FILE, CloseFile>;

std::string text_of(const ScratchFile& file) {
    std::string text;
    std::rewind(file.get());
    std::array<char, 4096> block{};
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
        text.append(block.data(), count);
    }
    return text;
}

bool write_all(int to, std::span<const char> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(to, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            return false;
        }
        bytes = bytes.subspan(written > 0 ? static_cast<std::size_t>(written) : 0);
    }
    return true;
}

bool write_file(int to, const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::vector<char> block(std::size_t{1} << 16U);
    while (stream) {
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        if (!write_all(to, std::span(block).first(static_cast<std::size_t>(stream.gcount())))) {
            return false;
        }
    }
    return true;
}

// A process with these standard streams; nothing if there is no such program. It has the usual
// treatment of signals, and a group of its own, so that Ctrl-C is ours to answer.
std::optional<pid_t> start(const std::vector<std::string>& words,
                           const std::array<int, 3>& streams) {
    std::vector<char*> arguments;
    for (const std::string& word : words) {
        arguments.push_back(const_cast<char*>(word.c_str()));
    }
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (int i = 0; i < 3; ++i) {
        posix_spawn_file_actions_adddup2(&actions, streams[static_cast<std::size_t>(i)], i);
    }
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    sigset_t ignored;
    sigemptyset(&ignored);
    sigaddset(&ignored, SIGPIPE);
    sigaddset(&ignored, SIGXFSZ);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &ignored);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(
        &attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    pid_t process = 0;
    const int failed =
        posix_spawnp(&process, arguments.front(), &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return failed == 0 ? std::optional(process) : std::nullopt;
}

}  // namespace

ProgramEnd run_program(const std::vector<std::string>& words,
                       std::span<const std::filesystem::path> input,
                       const std::function<void(std::size_t)>& progress,
                       const std::stop_token& stop) {
    ProgramEnd end;
    const ScratchFile output(std::tmpfile());
    const ScratchFile errors(std::tmpfile());
    std::array<int, 2> pipe{};
    if (!output || !errors || pipe2(pipe.data(), O_CLOEXEC) != 0) {
        end.errors = "no temporary file can be made";
        return end;
    }
    const auto process = start(words, {pipe[0], fileno(output.get()), fileno(errors.get())});
    ::close(pipe[0]);
    if (!process) {
        ::close(pipe[1]);
        end.found = false;
        return end;
    }
    const std::stop_callback on_stop(stop, [&process] { ::kill(*process, SIGTERM); });
    for (std::size_t i = 0; i < input.size() && !stop.stop_requested(); ++i) {
        if (progress) {
            progress(i);
        }
        if (!write_file(pipe[1], input[i])) {
            break;
        }
    }
    ::close(pipe[1]);
    int status = 0;
    while (waitpid(*process, &status, 0) < 0 && errno == EINTR) {
    }
    end.succeeded = WIFEXITED(status) && WEXITSTATUS(status) == 0 && !stop.stop_requested();
    end.output = text_of(output);
    end.errors = text_of(errors);
    return end;
}

}  // namespace balcony::app
