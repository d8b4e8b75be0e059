// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "balcony/base.hpp"
#include "cli/exit_code.hpp"

namespace balcony::cli {

// All output to a terminal passes through printable(), except the cursor movements of
// show_status().

/// Writes diagnostics to standard error.
void report(const Diagnostics& diagnostics);

/// Writes a result to standard output.
void print_result(std::string_view text);

/// Writes the text of a file to standard output; unchanged unless that is a terminal.
void print_file(std::string_view text);

/// Writes the bytes of a file to standard output; false if it did not take all that was written.
bool print_bytes(std::span<const std::uint8_t> bytes);

/// Writes a JSON document to standard output in ASCII. Replaces bytes that are not UTF-8.
void print_json(const nlohmann::json& document);

/// Flushes standard output. False if some output was lost, unless the reader closed the pipe.
[[nodiscard]] bool finish_output();

/// Writes a transient text to standard error.
void print_aside(std::string_view text);

/// Replaces the current line of the terminal by a text; an empty text clears the line.
void show_status(std::string_view text);

/// A count or a duration as readable text: "14.7 M", "3.2 s", "1:04 h".
[[nodiscard]] std::string count_text(double count);
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace balcony::cli
