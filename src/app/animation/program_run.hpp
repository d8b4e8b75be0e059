// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Runs another program.

#include <filesystem>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace balcony::app {

/// How a program ended, and what it wrote.
struct ProgramEnd {
    bool found = true;  ///< False if there is no such program.
    bool succeeded = false;
    std::string output;  ///< Of standard output.
    std::string errors;  ///< Of standard error.
};

/// Runs a program with the contents of files as its standard input, one after the other, until it
/// ends. `progress` is called before each file with its index. A stop ends the program.
[[nodiscard]] ProgramEnd run_program(const std::vector<std::string>& words,
                                     std::span<const std::filesystem::path> input = {},
                                     const std::function<void(std::size_t)>& progress = {},
                                     const std::stop_token& stop = {});

}  // namespace balcony::app
