// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "cli/exit_code.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

/// How a command answers.
struct Manner {
    bool quiet = false;  ///< Only with warnings and errors.
    bool json = false;
};

/// What a command says in the end: facts for programs or a text for people, and diagnostics.
struct Answer {
    Diagnostics diagnostics{};
    bool interrupted = false;
    nlohmann::json facts = nlohmann::json::object();  ///< Without the diagnostics.
    std::string text{};                               ///< Nothing is printed if it is empty.
    void (*print)(std::string_view) = print_result;   ///< Prints the text.

    /// Adds what was found; false if there is an error in it.
    bool add(const Diagnostics& found);
    /// Whether all went well to the end.
    [[nodiscard]] bool is_done() const { return !interrupted && !has_errors(diagnostics); }
};

/// The facts with the diagnostics.
[[nodiscard]] nlohmann::json to_json(const Answer& answer);

/// Prints an answer, the result on standard output and everything else on standard error. Returns
/// the exit code that follows from it.
ExitCode give(const Answer& answer, const Manner& manner);

}  // namespace balcony::cli
