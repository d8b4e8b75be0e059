// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Prints how long short runs of the command take: starting it is most of their time.

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench_case.hpp"

namespace balcony::bench {

namespace {

namespace fs = std::filesystem;

constexpr int start_runs = 21;

/// Milliseconds of one run: by the clock, and on processors.
struct RunTime {
    double wall = 0.0;
    double processor = 0.0;
};

double milliseconds(const timeval& time) {
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
}

RunTime run_command(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t quietly;
    posix_spawn_file_actions_init(&quietly);
    posix_spawn_file_actions_addopen(&quietly, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    const auto start = std::chrono::steady_clock::now();
    pid_t process = 0;
    const int failed =
        posix_spawn(&process, words.front().c_str(), &quietly, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&quietly);
    int status = 0;
    rusage used{};
    if (failed != 0 || wait4(process, &status, 0, &used) != process || status != 0) {
        throw std::runtime_error(fmt::format("'{} {}' fails", words[0], words[1]));
    }
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
    return {wall.count(), milliseconds(used.ru_utime) + milliseconds(used.ru_stime)};
}

/// A folder with a triangle to render.
class Folder {
public:
    Folder() {
        std::string name = (fs::temp_directory_path() / "balcony-start-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) {
            throw std::runtime_error("no temporary folder can be made");
        }
        path_ = name;
        std::ofstream(path_ / "scene.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }

    [[nodiscard]] std::string file(const char* name) const { return (path_ / name).string(); }

private:
    fs::path path_;
};

}  // namespace

void print_start() {
    const Folder folder;
    const std::string scene = folder.file("scene.obj");
    const std::vector<std::vector<std::string>> commands{
        {"--version"},
        {"list", "cameras"},
        {"complete", "render", scene, "--camera", "p"},
        {"check", "panorama"},
        {"draw", "panorama", "-o", folder.file("rays.svg")},
        {"render", scene, "--size", "16x9", "-s", "1", "-q", "-o", folder.file("picture.exr")},
        {"render", scene, "--size", "16x9", "-s", "1", "-q", "-o", folder.file("picture.png")}};
    fmt::print("milliseconds from start to end, {} runs each\n\n", start_runs);
    fmt::print("{:<24}{:>12}{:>12}{:>12}\n", "balcony", "median", "least", "processor");
    for (const auto& words : commands) {
        std::vector<std::string> line{BALCONY_COMMAND};
        line.insert(line.end(), words.begin(), words.end());
        std::vector<double> walls;
        std::vector<double> processors;
        for (int run = 0; run < start_runs; ++run) {
            const RunTime time = run_command(line);
            walls.push_back(time.wall);
            processors.push_back(time.processor);
        }
        std::sort(walls.begin(), walls.end());
        std::sort(processors.begin(), processors.end());
        const std::string end = words[0] == "render" ? fs::path(words.back()).extension().string()
                                : words.size() > 1   ? words[1]
                                                     : "";
        fmt::print("{:<24}{:>12.1f}{:>12.1f}{:>12.1f}\n", words[0] + " " + end,
                   walls[start_runs / 2], walls.front(), processors[start_runs / 2]);
    }
}

}  // namespace balcony::bench
