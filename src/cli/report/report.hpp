// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "balcony/base.hpp"
#include "cli/commands/command.hpp"

namespace balcony::cli {

// Whatever is written to a terminal passes through printable(), but for the cursor's movements of
// show_status().

/// Writes diagnostics to standard error.
void report(const Diagnostics& diagnostics);

/// Writes a result to standard output.
void print_result(std::string_view text);

/// Writes the text of a file to standard output: as it is, unless that is a terminal.
void print_file(std::string_view text);

/// Writes a JSON document to standard output in ASCII; what is not UTF-8 is replaced.
void print_json(const nlohmann::json& document);

/// Sends on what was written to standard output. False if it did not all arrive, unless whoever
/// read it has read enough.
[[nodiscard]] bool finish_output();

/// Writes to standard error what is gone if nobody can read it.
void print_aside(std::string_view text);

/// Writes a text over the line of the terminal in which the cursor is; an empty one clears it.
void show_status(std::string_view text);

/// "1 mesh", "3 meshes".
[[nodiscard]] std::string counted(std::size_t count, std::string_view one, std::string_view many);

/// Writes a count, a duration for people: 14.7 M, 3.2 s, 1:04 h.
[[nodiscard]] std::string count_text(double count);
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace balcony::cli
