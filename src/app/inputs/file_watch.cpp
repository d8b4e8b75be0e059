// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/inputs/file_watch.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

namespace balcony::app {

namespace fs = std::filesystem;

FileWatch::State FileWatch::state_of(const fs::path& file) {
    std::error_code failed;
    const Time time = fs::last_write_time(file, failed);
    if (failed) {
        return {};
    }
    const std::uintmax_t size = fs::is_regular_file(file, failed) ? fs::file_size(file, failed) : 0;
    return {true, time, size};
}

FileWatch::FileWatch(const std::vector<fs::path>& files) {
    for (const fs::path& file : files) {
        states_.emplace(file, state_of(file));
    }
}

FileWatch::FileWatch(const std::vector<fs::path>& files, Time since) : FileWatch(files) {
    // A file from the future tells nothing.
    const Time now = Time::clock::now();
    changed_while_read_ = std::any_of(states_.begin(), states_.end(), [&](const auto& known) {
        return known.second.exists && known.second.time > since && known.second.time <= now;
    });
}

bool FileWatch::has_changed() const {
    return changed_while_read_ ||
           std::any_of(states_.begin(), states_.end(),
                       [](const auto& known) { return state_of(known.first) != known.second; });
}

FileWatch FileWatch::renewed() const {
    FileWatch made;
    for (const auto& [file, state] : states_) {
        made.states_.emplace(file, state_of(file));
    }
    return made;
}

namespace {

bool has_any_changed(const std::vector<FileWatch>& watches) {
    return std::any_of(watches.begin(), watches.end(),
                       [](const FileWatch& watch) { return watch.has_changed(); });
}

}  // namespace

bool wait_for_change(const std::vector<FileWatch>& watches, const std::stop_token& stop) {
    constexpr auto interval = std::chrono::milliseconds(50);
    std::vector<FileWatch> expected = watches;
    bool changed = false;
    while (!stop.stop_requested()) {
        const bool changes = has_any_changed(expected);
        if (changed && !changes) {
            return true;
        }
        if (changes) {
            changed = true;
            for (FileWatch& watch : expected) {
                watch = watch.renewed();
            }
        }
        std::this_thread::sleep_for(interval);
    }
    return false;
}

}  // namespace balcony::app
