// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "balcony/options.hpp"
#include "cli/report/answer.hpp"

namespace balcony::cli {

/// A subcommand whose options are rows.
class Command final : public CLI::App {
public:
    Command(const std::string& name, const std::string& meaning, CLI::App* parent)
        : CLI::App(meaning, name, parent) {}

    /// Adds options whose values go to a target, which must outlive the command.
    template <class Target>
    Command& add(app::Options<Target> options, Target& target) {
        for (const app::Option<Target>& row : options.rows) {
            add_row(row);
        }
        readers_.push_back([options = std::move(options), &target](const app::GivenWords& given,
                                                                   Diagnostics& found) {
            options.read(given, target, found);
        });
        return *this;
    }

    /// All options but --help.
    [[nodiscard]] const std::vector<app::OptionInfo>& rows() const { return rows_; }
    /// What is known of an option; null for --help.
    [[nodiscard]] const app::OptionInfo* row_of(const CLI::Option* option) const;
    [[nodiscard]] bool has_flag(std::string_view name) const { return given().contains(name); }

    /// The words of a command line with the names of the rows in place of the others that they
    /// have. An error if such a name is not taken.
    [[nodiscard]] Result<std::vector<std::string>> in_own_words(
        const std::vector<std::string>& words) const;
    /// The help shows these options; `--help all` shows the others, too.
    void show_first(const std::vector<std::string>& names);

    /// The options of the command line that was parsed, with their words.
    [[nodiscard]] app::GivenWords given() const;
    /// Reads them into their targets.
    [[nodiscard]] Diagnostics read() const;

private:
    struct OtherName {
        const app::OptionInfo* row;
        std::string value;
        bool is_taken;
    };
    [[nodiscard]] std::optional<OtherName> find_other(std::string_view name) const;
    [[nodiscard]] Diagnostics check_words() const;
    void add_row(const app::OptionInfo& info);

    std::vector<app::OptionInfo> rows_;
    std::vector<CLI::Option*> parsed_;  ///< By row.
    std::deque<bool> flags_;
    std::vector<std::function<void(const app::GivenWords&, Diagnostics&)>> readers_;
};

// The subcommands in the order of the help, a row each. The file of NAME defines
// add_NAME_command().
#define BALCONY_COMMANDS(ROW) \
    ROW(demo)                 \
    ROW(render)               \
    ROW(animate)              \
    ROW(merge)                \
    ROW(dataset)              \
    ROW(check)                \
    ROW(explain)              \
    ROW(fmt)                  \
    ROW(studio)               \
    ROW(page)                 \
    ROW(lsp)                  \
    ROW(list)                 \
    ROW(locate)               \
    ROW(solve)                \
    ROW(info)                 \
    ROW(draw)                 \
    ROW(rays)                 \
    ROW(stmap)                \
    ROW(warp)                 \
    ROW(blend)                \
    ROW(export)               \
    ROW(pov)

/// Each function adds its subcommand to the app. If the command line selects the subcommand,
/// parsing runs it and stores its exit code in `code`. Results go to standard output, everything
/// else to standard error. With --json, a subcommand prints one JSON object with a list
/// "diagnostics".
#define BALCONY_DECLARE(NAME) void add_##NAME##_command(CLI::App& app, ExitCode& code);
BALCONY_COMMANDS(BALCONY_DECLARE)
#undef BALCONY_DECLARE

/// The body of such a function. `describe` adds the options, whose values go to an Options; `run`
/// is the subcommand. It is not called if a word cannot be read.
template <class Options, class Describe>
Command& add_command(CLI::App& app, ExitCode& code, const std::string& name,
                     const std::string& meaning, ExitCode (*run)(const Options&),
                     const Describe& describe) {
    const auto command = std::make_shared<Command>(name, meaning, &app);
    app.add_subcommand(command);
    command->group("Commands");
    const auto options = std::make_shared<Options>();
    describe(*command, *options);
    command->callback([&command = *command, options, run, &code] {
        const Diagnostics found = command.read();
        code =
            has_errors(found) ? give({found}, {.json = command.has_flag("--json")}) : run(*options);
    });
    return *command;
}

}  // namespace balcony::cli
