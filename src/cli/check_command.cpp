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
    nlohmann::json files = nlohmann::json::array();
    for (const std::string& file : options.files) {
        const Diagnostics said = lang::check(file);
        all.insert(all.end(), said.begin(), said.end());
        const auto cameras = lang::describe(file);
        const std::size_t count = cameras ? cameras->size() : 0;
        files.push_back({{"file", file}, {"cameras", count}, {"good", !has_errors(said)}});
        if (options.json) {
            continue;
        }
        report(said);
        if (!has_errors(said)) {
            print_result(fmt::format("{}: {}, no errors\n", printable(file),
                                     counted(count, "camera", "cameras")));
        }
    }
    if (options.json) {
        print_json({{"files", files}, {"diagnostics", to_json(all)}});
    }
    return has_errors(all) ? ExitCode::bad_input : ExitCode::done;
}

}  // namespace

void add_check_command(CLI::App& app, ExitCode& code) {
    auto* command = app.add_subcommand("check", "says what is wrong with camera files");
    command->group("Commands");
    const auto options = std::make_shared<CheckOptions>();
    command->add_option("FILE", options->files, "camera files (.cam)")->required()->take_all();
    command->add_flag("--json", options->json, "files and diagnostics, for programs");
    command->footer("Example:\n  balcony check gallery.cam room.cam");
    command->callback([options, &code] { code = check(*options); });
}

}  // namespace balcony::cli
