// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

namespace balcony::cli {

/// How the command ends, for scripts.
enum class ExitCode : int {
    done = 0,
    bad_input = 1,
    wrong_usage = 2,
    environment = 3,  ///< The disk is full, a program is missing, ...
    interrupted = 130,
};

/// Each adds its subcommand to the app; if the user asked for it, its exit code is in `code` after
/// parsing. With --json each prints one JSON object, whose "diagnostics" are a list; results go to
/// standard output, all else to standard error.
void add_render_command(CLI::App& app, ExitCode& code);
void add_check_command(CLI::App& app, ExitCode& code);
void add_explain_command(CLI::App& app, ExitCode& code);
void add_fmt_command(CLI::App& app, ExitCode& code);
void add_list_command(CLI::App& app, ExitCode& code);
void add_locate_command(CLI::App& app, ExitCode& code);
void add_draw_command(CLI::App& app, ExitCode& code);
void add_info_command(CLI::App& app, ExitCode& code);

}  // namespace balcony::cli
