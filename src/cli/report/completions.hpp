// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "cli/command_line.hpp"

namespace balcony::cli {

/// How the last of the words of a command line can go on, for the completion of shells: one word
/// per line, with a description behind a tab. The options are those of --help. A word that ends in
/// '/', ':' or '=' is to be continued.
[[nodiscard]] std::string completions(const CLI::App& app, std::span<const std::string> words);

}  // namespace balcony::cli
