// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace balcony::bridge::povray {

/// A program to run: without a shell, so that names may have any characters.
struct Command {
    std::filesystem::path program;
    std::vector<std::string> arguments;
    std::filesystem::path folder{};  ///< It runs there; in the current folder if empty.
};

struct ProcessResult {
    /// Nothing if the program could not be started or was ended by a signal.
    std::optional<int> exit_code;
    std::string output;  ///< Of both streams.
};

/// Runs a program to its end and returns what it has printed. The callback receives this as it
/// comes. When a stop is requested, the program is ended: politely first, then by force.
[[nodiscard]] ProcessResult run_process(const Command& command,
                                        const std::function<void(std::string_view)>& show = {},
                                        const std::stop_token& stop = {});

}  // namespace balcony::bridge::povray
