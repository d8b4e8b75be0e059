// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/exit_code.hpp"

namespace balcony::cli {

ExitCode exit_code_of(const Diagnostics& diagnostics, bool interrupted) {
    const std::optional<Kind> kind = kind_of_errors(diagnostics);
    if (!kind) {
        return interrupted ? ExitCode::interrupted : ExitCode::done;
    }
    switch (*kind) {
        case Kind::input: return ExitCode::bad_input;
        case Kind::usage: return ExitCode::wrong_usage;
        case Kind::interrupted: return ExitCode::interrupted;
        case Kind::environment:
        case Kind::internal: return ExitCode::environment;
    }
    return ExitCode::environment;
}

}  // namespace balcony::cli
