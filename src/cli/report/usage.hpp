// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "balcony/base.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

/// The heading of the options that only the whole help shows.
inline constexpr std::string_view more_options = "More options";

/// Formats help texts within 80 columns, with options as a user writes them.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> help_layout(bool whole);

/// "-o, --output FILE", or the name of an argument.
[[nodiscard]] std::string spelling(const CLI::Option& option);

/// The description of an option with its default.
[[nodiscard]] std::string meaning(const CLI::Option& option);

/// Whether one of several scenes looks like the value of an option instead.
[[nodiscard]] bool is_misplaced(const CLI::App& command, const std::string& word);

/// The error of a command line that `app` rejected, and what was probably intended.
[[nodiscard]] Diagnostic usage_error(const CLI::App& app, const CLI::ParseError& problem);

}  // namespace balcony::cli
