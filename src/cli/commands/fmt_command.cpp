// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <iostream>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "balcony/lang.hpp"
#include "balcony/output_file.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/command_rows.hpp"

namespace balcony::cli {

namespace {

struct FmtOptions {
    std::vector<std::string> files;
    bool check = false;
    Manner manner;
};

struct Formatted {
    Diagnostics diagnostics;
    bool changed = false;
    std::optional<std::string> text{};  // The formatted standard input.
};

Diagnostic not_in_layout(std::string_view file, std::string_view command) {
    return error(fmt::format("'{}' is not formatted", file), {}, fmt::format("run: {}", command));
}

// Formats standard input to standard output, as editors expect.
Formatted format_input(bool only_check) {
    const std::string text(std::istreambuf_iterator<char>(std::cin), {});
    const Result<std::string> made =
        lang::format(std::make_shared<const SourceText>("standard input", text));
    if (!made) {
        return {made.diagnostics};
    }
    Formatted formatted{made.diagnostics, *made != text, only_check ? std::nullopt : made.value};
    if (formatted.changed && only_check) {
        formatted.diagnostics.push_back(not_in_layout("standard input", "balcony fmt -"));
    }
    return formatted;
}

Formatted format_file(const std::string& file, bool only_check) {
    const Result<std::shared_ptr<const SourceText>> source = lang::read_text(file);
    if (!source) {
        return {source.diagnostics};
    }
    const Result<std::string> made = lang::format(*source);
    if (!made) {
        return {made.diagnostics};
    }
    Formatted formatted{made.diagnostics, *made != (*source)->text()};
    if (formatted.changed && only_check) {
        formatted.diagnostics.push_back(not_in_layout(file, fmt::format("balcony fmt {}", file)));
    } else if (formatted.changed) {
        const Diagnostics failed = write_whole(file, *made);
        formatted.diagnostics.insert(formatted.diagnostics.end(), failed.begin(), failed.end());
    }
    return formatted;
}

ExitCode format(const FmtOptions& options) {
    Answer all;
    for (const std::string& file : options.files) {
        const bool piped = file == "-";
        const Formatted formatted =
            piped ? format_input(options.check) : format_file(file, options.check);
        all.facts["files"].push_back({{"file", file}, {"changed", formatted.changed}});
        if (formatted.text) {
            all.facts["files"].back()["text"] = *formatted.text;
        }
        const bool good = all.add(formatted.diagnostics);
        if (!options.manner.json) {
            report(formatted.diagnostics);
            print_file(formatted.text.value_or(""));
            if (formatted.changed && good && !piped) {
                print_result(fmt::format("{}: formatted\n", printable(file)));
            }
        }
    }
    if (options.manner.json) {
        print_json(to_json(all));
    }
    return exit_code_of(all.diagnostics);
}

}  // namespace

void add_fmt_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, FmtOptions& options) {
        command.add<FmtOptions>(
            {{app::words({.name = "FILE",
                          .meaning = "camera files (.cam), formatted in place; - formats standard "
                                     "input to standard output",
                          .required = true,
                          .type = OptionType::camera},
                         &FmtOptions::files),
              flag({.name = "--check",
                    .meaning = "change nothing; exit with code 1 if a file is not formatted"},
                   true, &FmtOptions::check),
              json_flag(&FmtOptions::manner, "print files and diagnostics as JSON")}},
            options);
        command.footer("Examples:\n  balcony fmt my.cam\n  balcony fmt --check *.cam");
    };
    add_command<FmtOptions>(app, code, "fmt", "formats camera files", format, describe);
}

}  // namespace balcony::cli
