// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <stop_token>
#include <vector>

namespace balcony::app {

/// Notices changes of files by asking for their states, which works for files that an editor
/// replaces, that do not exist yet, or that are on another machine.
class FileWatch {
public:
    using Time = std::filesystem::file_time_type;

    /// Files that are read afterwards, or whose present state is known to have been read.
    explicit FileWatch(const std::vector<std::filesystem::path>& files);
    /// Files that have been read since a time: one that was written meanwhile has changed. The
    /// times of files are some milliseconds coarser than a clock.
    FileWatch(const std::vector<std::filesystem::path>& files, Time since);

    [[nodiscard]] bool has_changed() const;
    /// The same files in their present state.
    [[nodiscard]] FileWatch renewed() const;
    [[nodiscard]] std::size_t size() const { return states_.size(); }

private:
    FileWatch() = default;

    struct State {
        bool exists = false;
        Time time{};
        std::uintmax_t size = 0;
        bool operator==(const State&) const = default;
    };
    static State state_of(const std::filesystem::path& file);

    std::map<std::filesystem::path, State> states_;
    bool changed_while_read_ = false;
};

/// Waits until one of the watched files has changed, and none changes any more. False if a stop is
/// requested before.
[[nodiscard]] bool wait_for_change(const std::vector<FileWatch>& watches,
                                   const std::stop_token& stop);

}  // namespace balcony::app
