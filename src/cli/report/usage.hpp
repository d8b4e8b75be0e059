// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "balcony/base.hpp"
#include "cli/commands/command.hpp"

namespace balcony::cli {

/// How help is laid out: within 80 columns, options as a user writes them.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> help_layout();

/// What is wrong with a command line that `app` did not take, and what was probably meant.
[[nodiscard]] Diagnostic usage_error(const CLI::App& app, const CLI::ParseError& problem);

}  // namespace balcony::cli
