// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/manual.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "balcony/output_file.hpp"
#include "cli/report/usage.hpp"

namespace balcony::cli {

namespace {

// A text in which no character is a command of roff.
std::string escaped(std::string_view text) {
    std::string made;
    bool at_start = true;
    for (const char c : text) {
        made += at_start && (c == '.' || c == '\'') ? "\\&" : "";
        made += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
        at_start = c == '\n';
    }
    return made;
}

std::string title_of(std::string name) {
    std::transform(name.begin(), name.end(), name.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
    return name;
}

std::string beginning(const std::string& name, const std::string& meaning) {
    return fmt::format(".TH {} 1 \"\" \"Balcony {}\" \"Balcony\"\n.SH NAME\n{} \\- {}\n",
                       title_of(name), BALCONY_VERSION, escaped(name), escaped(meaning));
}

std::string entry(const std::string& name, const std::string& meaning) {
    return fmt::format(".TP\n.B {}\n{}\n", escaped(name), escaped(meaning));
}

std::string options_text(const CLI::App& command, bool positional) {
    std::string text;
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_positional() == positional) {
            text += entry(spelling(*option), meaning(*option));
        }
    }
    return text;
}

// What follows the options in --help: examples, as they are laid out.
std::string footer_text(const CLI::App& command) {
    return fmt::format(".SH NOTES\n.nf\n{}\n.fi\n", escaped(command.get_footer()));
}

std::string page_of(const CLI::App& command) {
    std::string arguments;
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_positional()) {
            const bool several = option->get_items_expected_max() > 1;
            const std::string name = option->get_name(true) + (several ? "..." : "");
            arguments += option->get_required() ? " " + name : " [" + name + "]";
        }
    }
    std::string text = beginning("balcony-" + command.get_name(), command.get_description());
    text += fmt::format(".SH SYNOPSIS\n.B balcony {}\n[options]{}\n", escaped(command.get_name()),
                        escaped(arguments));
    if (const std::string listed = options_text(command, true); !listed.empty()) {
        text += ".SH ARGUMENTS\n" + listed;
    }
    text += ".SH OPTIONS\n" + options_text(command, false) + footer_text(command);
    return text + ".SH SEE ALSO\n.BR balcony (1)\n";
}

std::string overview(const CLI::App& app, const std::vector<const CLI::App*>& commands) {
    std::string text = beginning("balcony", "renders 3D scenes through extended cameras");
    text += ".SH SYNOPSIS\n.B balcony\nCOMMAND [options] [arguments]\n.SH DESCRIPTION\n" +
            escaped(app.get_description()) + "\n.SH COMMANDS\n";
    std::string pages;
    for (const CLI::App* command : commands) {
        text += entry(command->get_name(), command->get_description());
        pages += fmt::format("{}.BR balcony\\-{} (1)", pages.empty() ? "" : ",\n",
                             escaped(command->get_name()));
    }
    text += ".SH OPTIONS\n" + options_text(app, false) + footer_text(app);
    return text + ".SH SEE ALSO\n" + pages + "\n";
}

}  // namespace

Diagnostics write_manual(const CLI::App& app, const std::filesystem::path& folder) {
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    const std::vector<const CLI::App*> commands = app.get_subcommands({});
    Diagnostics found = write_whole(folder / "balcony.1", overview(app, commands));
    for (const CLI::App* command : commands) {
        if (found.empty()) {
            found = write_whole(folder / fmt::format("balcony-{}.1", command->get_name()),
                                page_of(*command));
        }
    }
    return found;
}

}  // namespace balcony::cli
