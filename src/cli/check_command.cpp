// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/lang.hpp"
#include "cli/command.hpp"
#include "cli/json.hpp"
#include "cli/report.hpp"

namespace balcony::cli {

namespace {

struct CheckOptions {
    std::vector<std::string> files;
    bool json = false;
};

ExitCode check(const CheckOptions& options) {
    Diagnostics all;
    for (const std::string& file : options.files) {
        const Diagnostics said = lang::check(file);
        all.insert(all.end(), said.begin(), said.end());
        if (!options.json) {
            report(said);
            if (!has_errors(said)) {
                const auto cameras = lang::describe(file);
                fmt::print("{}: {} camera{}, no errors\n", file, cameras->size(),
                           cameras->size() == 1 ? "" : "s");
            }
        }
    }
    if (options.json) {
        fmt::print("{}\n", to_json(all).dump(2));
    }
    return has_errors(all) ? ExitCode::bad_input : ExitCode::done;
}

}  // namespace

void add_check_command(CLI::App& app, ExitCode& code) {
    auto* command = app.add_subcommand("check", "says what is wrong with camera files");
    const auto options = std::make_shared<CheckOptions>();
    command->add_option("FILE", options->files, "camera files (.cam)")->required();
    command->add_flag("--json", options->json, "for programs: a list of diagnostics");
    command->footer("Example:\n  balcony check gallery.cam");
    command->callback([options, &code] { code = check(*options); });
}

}  // namespace balcony::cli
