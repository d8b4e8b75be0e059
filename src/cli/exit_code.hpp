// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/base.hpp"

namespace balcony::cli {

/// Exit codes of the command.
enum class ExitCode : int {
    done = 0,
    bad_input = 1,
    wrong_usage = 2,
    environment = 3,  ///< The disk is full, a program is missing, ...
    interrupted = 130,
};

/// That of what a command reports: by the kind of its first error.
[[nodiscard]] ExitCode exit_code_of(const Diagnostics& diagnostics, bool interrupted = false);

}  // namespace balcony::cli
