// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/usage.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "balcony/display_file.hpp"
#include "balcony/inputs.hpp"
#include "balcony/lang.hpp"
#include "balcony/names.hpp"

namespace balcony::cli {

namespace {

constexpr std::size_t text_column = 28;
constexpr std::size_t last_column = 80;

// Wraps a text at the text column; the first line starts at the cursor.
std::string wrapped(const std::string& text) {
    std::string lines;
    std::size_t column = text_column;
    for (const std::string& word : CLI::detail::split(text, ' ')) {
        if (column > text_column && column + 1 + word.size() > last_column) {
            lines += "\n" + std::string(text_column, ' ');
            column = text_column;
        } else if (column > text_column) {
            lines += ' ';
            ++column;
        }
        lines += word;
        column += word.size();
    }
    return lines;
}

// "  -o, --output FILE" and its description.
std::string entry(const std::string& name, const std::string& meaning) {
    const std::string indented = "  " + name;
    const std::string gap = indented.size() + 2 > text_column
                                ? "\n" + std::string(text_column, ' ')
                                : std::string(text_column - indented.size(), ' ');
    return indented + gap + wrapped(meaning) + "\n";
}

class HelpLayout final : public CLI::Formatter {
public:
    explicit HelpLayout(bool whole) : whole_(whole) {
        label("Positionals", "Arguments");
        label("OPTIONS", "options");
        label("SUBCOMMAND", "COMMAND");
    }

    std::string make_option(const CLI::Option* option, bool) const override {
        return entry(spelling(*option), meaning(*option));
    }

    std::string make_group(std::string group, bool is_positional,
                           std::vector<const CLI::Option*> options) const override {
        return whole_ || group != more_options
                   ? Formatter::make_group(std::move(group), is_positional, std::move(options))
                   : "--help all shows all options.\n";
    }

    std::string make_usage(const CLI::App* app, std::string name) const override {
        return "\n" + Formatter::make_usage(app, std::move(name));
    }

    std::string make_subcommand(const CLI::App* command) const override {
        return entry(command->get_name(), command->get_description());
    }

private:
    bool whole_;
};

std::vector<std::string> names_of_options(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    return names;
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) {
        names.push_back(command->get_name());
    }
    return names;
}

// CLI11's message, reworded for the most common mistakes.
std::string in_plain_words(const CLI::ParseError& problem) {
    const std::string message = problem.what();
    const std::string option = message.substr(0, message.find(':'));
    if (problem.get_name() == "ArgumentMismatch" && message.find("required") != std::string::npos) {
        return fmt::format("{} needs a value", option);
    }
    if (problem.get_name() == "ArgumentMismatch" || problem.get_name() == "ConversionError") {
        return fmt::format("{} takes no value", option.substr(0, option.find(' ')));
    }
    return message;
}

bool has_option(const CLI::App& command, const std::string& name) {
    return command.get_option_no_throw(name) != nullptr;
}

bool ends_in(std::string_view word, std::initializer_list<std::string_view> endings) {
    return std::any_of(endings.begin(), endings.end(),
                       [word](std::string_view ending) { return word.ends_with(ending); });
}

// CLI11 parses "-camera" as -c with the value "amera". Returns the intended option, if any.
std::optional<std::string> option_with_one_hyphen(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& value : option->results()) {
            for (const std::string& name : option->get_lnames()) {
                if (!option->get_snames().empty() && option->get_snames().front() + value == name) {
                    return "--" + name;
                }
            }
        }
    }
    return std::nullopt;
}

// The options of the command line that take no value.
std::vector<std::string> given_flags(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        if (option->count() > 0 && option->get_items_expected_max() == 0) {
            names.push_back(option->get_name());
        }
    }
    return names;
}

bool is_camera(const std::string& word) {
    const auto& built_in = lang::built_in_cameras();
    return word.ends_with(".cam") || word.find(".cam:") != std::string::npos ||
           std::find(built_in.begin(), built_in.end(), word) != built_in.end();
}

// The option that a surplus argument probably belongs to; empty if there is none.
std::string option_for(const CLI::App& command, const std::string& word) {
    if (const auto option = option_with_one_hyphen(command)) {
        return fmt::format("write {} with two hyphens", *option);
    }
    const bool of_numbers = word.find_first_not_of("0123456789.,-+e") == std::string::npos;
    const bool is_point = of_numbers && word.find(',') != std::string::npos;
    if (of_numbers && !is_point && has_option(command, "--point")) {
        return "write a point as one word: --point X,Y,Z";
    }
    if ((of_numbers && !is_point) || word == "on" || word == "true" || word == "yes") {
        const std::vector<std::string> flags = given_flags(command);
        return flags.empty() ? "an option has one value"
                             : fmt::format("write {} without a value", fmt::join(flags, " and "));
    }
    const char* option =
        is_camera(word)                                                              ? "--camera"
        : render::display_format(word) != nullptr || ends_in(word, {".exr", ".svg"}) ? "--output"
        : app::is_scene_file(word)                                                   ? "--scene"
        : is_point                                                                   ? "--point"
        : word.find('=') != std::string::npos && word[0] != '='                      ? "--set"
                                                                                     : nullptr;
    return option != nullptr && has_option(command, option)
               ? fmt::format("did you mean {} {}?", option, word)
               : "";
}

Diagnostic unexpected(const std::string& word, std::string remedy) {
    return error(Kind::usage, fmt::format("'{}' is an unexpected argument", word),
                 std::move(remedy));
}

// The first of several arguments that looks like the value of an option.
Diagnostic misplaced_argument(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& word :
             option->get_positional() ? option->results() : std::vector<std::string>()) {
            if (is_misplaced(command, word)) {
                return unexpected(word, option_for(command, word));
            }
        }
    }
    return error(Kind::usage, "an argument is unexpected");
}

// The command for a file that was given in place of a command.
std::string command_for(const std::string& word) {
    return app::is_scene_file(word)  ? fmt::format("did you mean balcony render {}?", word)
           : ends_in(word, {".cam"}) ? fmt::format("did you mean balcony check {}?", word)
                                     : "";
}

}  // namespace

std::string spelling(const CLI::Option& option) {
    if (option.get_positional()) {
        return option.get_name(true);
    }
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) {
        names.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames()) {
        names.push_back("--" + name);
    }
    const bool is_flag = option.get_items_expected_max() == 0;
    return fmt::format("{}{}{}", fmt::join(names, ", "), is_flag ? "" : " ",
                       is_flag ? "" : option.get_type_name());
}

std::string meaning(const CLI::Option& option) {
    const std::string standard = option.get_default_str();
    return standard.empty() ? option.get_description()
                            : fmt::format("{} (default: {})", option.get_description(), standard);
}

std::shared_ptr<CLI::FormatterBase> help_layout(bool whole) {
    return std::make_shared<HelpLayout>(whole);
}

bool is_misplaced(const CLI::App& command, const std::string& word) {
    return !app::is_scene_file(word) && !option_for(command, word).empty();
}

Diagnostic usage_error(const CLI::App& app, const CLI::ParseError& problem) {
    const auto chosen = app.get_subcommands();
    const CLI::App& command = chosen.empty() ? app : *chosen.front();
    const std::string name = chosen.empty() ? "balcony" : "balcony " + command.get_name();
    const std::string look_up = name + " --help";

    const std::vector<std::string> unknown = app.remaining(true);
    const auto option = std::find_if(unknown.begin(), unknown.end(), [](const std::string& word) {
        return word.size() > 1 && word.front() == '-';
    });
    const bool is_option = option != unknown.end();
    if (problem.get_name() == "ValidationError" && !is_option) {
        return misplaced_argument(command);
    }
    if (!is_option && (unknown.empty() || problem.get_name() == "ArgumentMismatch")) {
        return error(Kind::usage, chosen.empty() ? "no command is given" : in_plain_words(problem),
                     look_up);
    }
    const std::string word = is_option ? option->substr(0, option->find('=')) : unknown.front();
    if (!is_option && !chosen.empty()) {
        const std::string meant = option_for(command, word);
        return unexpected(word, meant.empty() ? look_up : meant);
    }
    return error(
        Kind::usage, fmt::format("{} has no {} '{}'", name, is_option ? "option" : "command", word),
        did_you_mean(word, is_option ? names_of_options(command) : names_of_commands(app),
                     is_option || command_for(word).empty() ? look_up : command_for(word)));
}

}  // namespace balcony::cli
