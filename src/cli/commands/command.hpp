// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/exit_code.hpp"

namespace balcony::cli {

/// Each function adds its subcommand to the app. If the command line selects the subcommand,
/// parsing runs it and stores its exit code in `code`. Results go to standard output, everything
/// else to standard error. With --json, a subcommand prints one JSON object with a list
/// "diagnostics".
void add_render_command(CLI::App& app, ExitCode& code);
void add_animate_command(CLI::App& app, ExitCode& code);
void add_merge_command(CLI::App& app, ExitCode& code);
void add_rays_command(CLI::App& app, ExitCode& code);
void add_stmap_command(CLI::App& app, ExitCode& code);
void add_warp_command(CLI::App& app, ExitCode& code);
void add_check_command(CLI::App& app, ExitCode& code);
void add_explain_command(CLI::App& app, ExitCode& code);
void add_fmt_command(CLI::App& app, ExitCode& code);
void add_list_command(CLI::App& app, ExitCode& code);
void add_locate_command(CLI::App& app, ExitCode& code);
void add_draw_command(CLI::App& app, ExitCode& code);
void add_export_command(CLI::App& app, ExitCode& code);
void add_info_command(CLI::App& app, ExitCode& code);
void add_pov_command(CLI::App& app, ExitCode& code);

/// The body of such a function. `describe` adds the options, whose values it stores in an Options;
/// `run` is the subcommand.
template <class Options, class Describe>
CLI::App& add_command(CLI::App& app, ExitCode& code, const std::string& name,
                      const std::string& meaning, ExitCode (*run)(const Options&),
                      const Describe& describe) {
    CLI::App* command = app.add_subcommand(name, meaning);
    command->group("Commands");
    const auto options = std::make_shared<Options>();
    describe(*command, *options);
    command->callback([options, run, &code] { code = run(*options); });
    return *command;
}

}  // namespace balcony::cli
