// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <iostream>
#include <iterator>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/lang.hpp"
#include "balcony/output_file.hpp"
#include "cli/commands/command.hpp"
#include "cli/report/json.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

struct FmtOptions {
    std::vector<std::string> files;
    bool check = false;
    bool json = false;
};

struct Outcome {
    Diagnostics diagnostics;
    bool changed = false;
    bool written = true;
    std::optional<std::string> text{};  // The formatted standard input.
};

Diagnostic not_in_layout(std::string_view file, std::string_view command) {
    return error(fmt::format("'{}' is not formatted", file), {}, fmt::format("run: {}", command));
}

// Formats standard input to standard output, as editors expect.
Outcome format_input(bool only_check) {
    const std::string text(std::istreambuf_iterator<char>(std::cin), {});
    const Result<std::string> made =
        lang::format(std::make_shared<const SourceText>("standard input", text));
    if (!made) {
        return {made.diagnostics};
    }
    Outcome outcome{made.diagnostics, *made != text, true, only_check ? std::nullopt : made.value};
    if (outcome.changed && only_check) {
        outcome.diagnostics.push_back(not_in_layout("standard input", "balcony fmt -"));
    }
    return outcome;
}

Outcome format_file(const std::string& file, bool only_check) {
    const Result<std::shared_ptr<const SourceText>> source = lang::read_text(file);
    if (!source) {
        return {source.diagnostics};
    }
    const Result<std::string> made = lang::format(*source);
    if (!made) {
        return {made.diagnostics};
    }
    Outcome outcome{made.diagnostics, *made != (*source)->text(), true};
    if (outcome.changed && only_check) {
        outcome.diagnostics.push_back(not_in_layout(file, fmt::format("balcony fmt {}", file)));
    } else if (outcome.changed) {
        const Diagnostics failed = write_whole(file, *made);
        outcome.written = failed.empty();
        outcome.diagnostics.insert(outcome.diagnostics.end(), failed.begin(), failed.end());
    }
    return outcome;
}

ExitCode format(const FmtOptions& options) {
    ExitCode code = ExitCode::done;
    Diagnostics all;
    nlohmann::json files = nlohmann::json::array();
    for (const std::string& file : options.files) {
        const bool piped = file == "-";
        const Outcome outcome =
            piped ? format_input(options.check) : format_file(file, options.check);
        all.insert(all.end(), outcome.diagnostics.begin(), outcome.diagnostics.end());
        files.push_back({{"file", file}, {"changed", outcome.changed}});
        if (outcome.text) {
            files.back()["text"] = *outcome.text;
        }
        if (!outcome.written) {
            code = ExitCode::environment;
        } else if (has_errors(outcome.diagnostics) && code == ExitCode::done) {
            code = ExitCode::bad_input;
        }
        if (!options.json) {
            report(outcome.diagnostics);
            print_file(outcome.text.value_or(""));
            if (outcome.changed && outcome.written && !piped && !options.check) {
                print_result(fmt::format("{}: formatted\n", printable(file)));
            }
        }
    }
    if (options.json) {
        print_json({{"files", files}, {"diagnostics", to_json(all)}});
    }
    return code;
}

}  // namespace

void add_fmt_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](CLI::App& command, FmtOptions& options) {
        command
            .add_option("FILE", options.files,
                        "camera files (.cam), formatted in place; - formats standard input to "
                        "standard output")
            ->required()
            ->take_all();
        command.add_flag("--check", options.check,
                         "change nothing; exit with code 1 if a file is not formatted");
        command.add_flag("--json", options.json, "print files and diagnostics as JSON");
        command.footer("Examples:\n  balcony fmt my.cam\n  balcony fmt --check *.cam");
    };
    add_command<FmtOptions>(app, code, "fmt", "formats camera files", format, describe);
}

}  // namespace balcony::cli
