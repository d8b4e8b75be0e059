// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/catalogue.hpp"
#include "balcony/lang.hpp"
#include "balcony/names.hpp"
#include "balcony/output_file.hpp"
#include "balcony/studies.hpp"
#include "camera/catalogue/stage_text.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/stage_pages.hpp"

namespace balcony::cli {

namespace {

using camera::StageEntry;
using camera::StageParameter;

struct ListOptions {
    std::string what;
    std::string search;
    std::string markdown;
    Manner manner;
    const CLI::App* app = nullptr;  ///< All commands.
};

std::string stage_text(const StageEntry& row) {
    std::string text =
        fmt::format("{}: {}\n    {}\n", name_of(row.kind), call_text(row), row.meaning);
    for (const StageParameter& parameter : row.parameters) {
        const std::string built_in = default_text(parameter);
        text += fmt::format("    {:<10} {}{}\n               {}\n", parameter.name,
                            type_text(parameter), built_in.empty() ? "" : ", default " + built_in,
                            parameter.meaning);
    }
    std::istringstream formula{std::string(stage_formula(row))};
    std::string line;
    text += "\n";
    while (std::getline(formula, line)) {
        text += fmt::format("      {}\n", line);
    }
    return text + "\n";
}

nlohmann::json stage_json(const StageEntry& row) {
    nlohmann::json parameters = nlohmann::json::array();
    for (const StageParameter& parameter : row.parameters) {
        parameters.push_back({{"name", parameter.name},
                              {"type", type_text(parameter)},
                              {"default", default_text(parameter)},
                              {"meaning", parameter.meaning}});
    }
    return {{"kind", name_of(row.kind)},
            {"name", row.name},
            {"meaning", row.meaning},
            {"formula", stage_formula(row)},
            {"parameters", parameters}};
}

// Whether "object generators", "object_generator", ... refers to a kind.
bool names_kind(std::string what, camera::StageKind kind) {
    std::replace(what.begin(), what.end(), '_', ' ');
    return what == name_of(kind) || what == plural_of(kind);
}

bool is_kind(const std::string& what) {
    const auto& rows = camera::catalogue();
    return std::any_of(rows.begin(), rows.end(),
                       [&](const StageEntry& row) { return names_kind(what, row.kind); });
}

// Whether the request includes a row: by 'stages', by its kind or by its own name.
bool is_listed(const StageEntry& row, const std::string& what) {
    return what == "stages" || row.name == what || names_kind(what, row.kind);
}

// Stages under the names of their kinds, one per line.
std::string stages_text(const std::string& what) {
    std::size_t longest = 0;
    for (const StageEntry& row : camera::catalogue()) {
        longest = std::max(longest, row.name.size());
    }
    std::string text;
    std::optional<camera::StageKind> heading;
    for (const StageEntry& row : camera::catalogue()) {
        if (!is_listed(row, what)) {
            continue;
        }
        if (heading != row.kind) {
            text += fmt::format("{}{}\n", heading ? "\n" : "", plural_of(row.kind));
            heading = row.kind;
        }
        text += fmt::format("  {:<{}} {}\n", row.name, longest, row.meaning);
    }
    return text;
}

Answer list_stages(const ListOptions& options) {
    const bool several = options.what == "stages" || is_kind(options.what);
    Answer answer;
    answer.text = several ? stages_text(options.what) : "";
    for (const StageEntry& row : camera::catalogue()) {
        if (is_listed(row, options.what)) {
            answer.facts["stages"].push_back(stage_json(row));
            answer.text += several ? "" : stage_text(row);
        }
    }
    return answer;
}

bool is_stage(const std::string& name) {
    const auto& rows = camera::catalogue();
    return std::any_of(rows.begin(), rows.end(),
                       [&](const StageEntry& row) { return row.name == name; });
}

bool is_built_in_camera(const std::string& name) {
    const auto& names = lang::built_in_cameras();
    return std::find(names.begin(), names.end(), name) != names.end();
}

nlohmann::json camera_json(const lang::Description& described) {
    nlohmann::json parameters = nlohmann::json::array();
    for (const auto& parameter : described.parameters) {
        nlohmann::json one{{"name", parameter.name}, {"default", parameter.default_text}};
        if (!parameter.limits_text.empty()) {
            one["limits"] = parameter.limits_text;
        }
        if (std::isfinite(parameter.limits.minimum)) {
            one["minimum"] = parameter.limits.minimum;
        }
        if (std::isfinite(parameter.limits.maximum)) {
            one["maximum"] = parameter.limits.maximum;
        }
        parameters.push_back(std::move(one));
    }
    return {{"name", described.name},       {"kind", described.is_picture ? "picture" : "camera"},
            {"comment", described.comment}, {"keywords", described.keywords},
            {"parameters", parameters},     {"layers", described.layers}};
}

std::string first_sentence(const std::string& comment) {
    for (std::size_t i = 0; i < comment.size(); ++i) {
        const bool at_end =
            i + 1 == comment.size() || comment[i + 1] == ' ' || comment[i + 1] == '\n';
        if (comment[i] == '.' && at_end) {
            return comment.substr(0, i + 1);
        }
    }
    return comment;
}

// The whole comment of a single camera, or the first sentence of each of several.
std::string camera_text(const lang::Description& described, bool whole) {
    std::vector<std::string> parameters;
    for (const auto& parameter : described.parameters) {
        parameters.push_back(fmt::format("{} = {}{}{}", parameter.name, parameter.default_text,
                                         parameter.limits_text.empty() ? "" : " ",
                                         parameter.limits_text));
    }
    std::string text = fmt::format("{}{}({})\n", described.is_picture ? "picture " : "",
                                   described.name, fmt::join(parameters, ", "));
    std::istringstream comment(whole ? described.comment : first_sentence(described.comment));
    std::string line;
    while (std::getline(comment, line)) {
        text += line.empty() ? "\n" : fmt::format("    {}\n", line);
    }
    if (described.is_picture) {
        text += fmt::format("    layers: {}\n", fmt::join(described.layers, ", "));
    }
    return text;
}

std::vector<std::string> names_of(std::string_view family) {
    std::vector<std::string> names;
    for (const std::string& name : lang::built_in_cameras()) {
        if (lang::family_of(name) == family) {
            names.push_back(name);
        }
    }
    return names;
}

// A family whose lines would push the others off the screen is shown by its names.
bool is_large(std::string_view family) {
    constexpr std::size_t most_lines = 30;
    return names_of(family).size() > most_lines;
}

std::string names_text(std::string_view family) {
    constexpr std::size_t line_width = 90;
    std::string text;
    std::string line;
    for (const std::string& name : names_of(family)) {
        if (line.size() + name.size() >= line_width) {
            text += " " + line + "\n";
            line.clear();
        }
        line += " " + name;
    }
    return text + " " + line + "\n  What one is for: balcony list NAME\n";
}

std::size_t longest_name(const std::vector<lang::Description>& cameras) {
    std::size_t longest = 0;
    for (const lang::Description& described : cameras) {
        longest = std::max(longest, described.name.size());
    }
    return longest;
}

// One line with what it is for.
std::string line_of(const lang::Description& described, std::size_t longest) {
    std::string use = first_sentence(described.comment);
    std::replace(use.begin(), use.end(), '\n', ' ');
    return fmt::format("  {:<{}} {}\n", described.name, longest, use);
}

// Under the names of their families, one per line.
std::string built_in_text(const std::vector<lang::Description>& cameras) {
    const std::size_t longest = longest_name(cameras);
    std::string text;
    std::string_view heading;
    for (const lang::Description& described : cameras) {
        const std::string_view family = lang::family_of(described.name);
        if (heading != family) {
            text += fmt::format("{}{}\n", heading.empty() ? "" : "\n", family);
            heading = family;
            if (is_large(family)) {
                text += names_text(family);
            }
        }
        if (is_large(family)) {
            continue;
        }
        text += line_of(described, longest);
    }
    return text;
}

std::string cameras_text(const std::vector<lang::Description>& cameras) {
    std::string text;
    for (const lang::Description& described : cameras) {
        text += camera_text(described, cameras.size() == 1);
    }
    return text;
}

Answer list_cameras(const ListOptions& options) {
    const bool built_in = options.what == "cameras";
    const auto cameras =
        built_in ? app::describe_built_in() : lang::Workspace().describe(options.what);
    Answer answer;
    nlohmann::json& all = answer.facts["cameras"] = nlohmann::json::array();
    if (!answer.add(cameras.diagnostics)) {
        return answer;
    }
    for (const lang::Description& described : *cameras) {
        all.push_back(camera_json(described));
        if (built_in) {
            all.back()["family"] = lang::family_of(described.name);
        }
    }
    answer.text = built_in ? built_in_text(*cameras) : cameras_text(*cameras);
    return answer;
}

// Those of a search or a family, of which not too many are shown.
Answer list_found(const std::vector<std::string>& names, std::size_t most) {
    Answer answer;
    nlohmann::json& all = answer.facts["cameras"] = nlohmann::json::array();
    const auto known = app::describe_built_in();
    if (!answer.add(known.diagnostics)) {
        return answer;
    }
    std::vector<lang::Description> shown;
    for (const std::string& name : names) {
        const auto one =
            std::find_if(known->begin(), known->end(),
                         [&name](const lang::Description& other) { return other.name == name; });
        all.push_back(camera_json(*one));
        all.back()["family"] = lang::family_of(name);
        if (shown.size() < most) {
            shown.push_back(*one);
        }
    }
    for (const lang::Description& one : shown) {
        answer.text += line_of(one, longest_name(shown));
    }
    if (shown.size() < names.size()) {
        answer.text += fmt::format("  and {} more\n", names.size() - shown.size());
    }
    return answer;
}

Answer search(const std::string& words) {
    constexpr std::size_t most = 12;
    std::vector<std::string> names;
    for (const lang::CameraMatch& match : lang::search_built_in_cameras(words)) {
        names.push_back(match.name);
    }
    return names.empty() ? Answer{{error(fmt::format("no built-in camera is found by '{}'", words),
                                         {}, "'balcony list cameras' shows all of them")}}
                         : list_found(names, most);
}

Answer refuse_unknown(const ListOptions& options) {
    std::vector<std::string> known{"stages", "cameras", "options"};
    for (const StageEntry& row : camera::catalogue()) {
        known.emplace_back(row.name);
        known.push_back(plural_of(row.kind));
    }
    return {
        {error(Kind::usage,
               fmt::format("there is no stage, built-in camera or file named '{}'", options.what),
               did_you_mean(options.what, known, lang::instead_of_camera(options.what)))}};
}

// Writes the pages of the documentation. No page is ever incomplete.
Answer write_pages(const ListOptions& options) {
    Answer answer;
    for (const StagePage& page : stage_pages()) {
        const std::filesystem::path file = std::filesystem::path(options.markdown) / page.file;
        std::error_code failed;
        std::filesystem::create_directories(file.parent_path(), failed);
        if (!answer.add(write_whole(file, page.text))) {
            break;
        }
    }
    return answer;
}

nlohmann::json option_json(const app::OptionInfo& row) {
    nlohmann::json choices = nlohmann::json::array();
    for (const app::OptionChoice& one : row.choices) {
        choices.push_back({{"name", one.name}, {"meaning", one.meaning}});
    }
    nlohmann::json made{{"name", row.name},
                        {"letter", row.letter},
                        {"type", app::option_types()[row.type].name},
                        {"placeholder", row.placeholder},
                        {"meaning", row.meaning},
                        {"default", row.fallback},
                        {"required", row.required},
                        {"repeated", row.repeated},
                        {"words", row.words},
                        {"unit", row.unit},
                        {"minimum", nullptr},
                        {"maximum", nullptr},
                        {"choices", std::move(choices)}};
    if (std::isfinite(row.minimum)) {
        made["minimum"] = row.minimum;
    }
    if (std::isfinite(row.maximum)) {
        made["maximum"] = row.maximum;
    }
    return made;
}

// The options of all commands, from which another program can build its own.
Answer list_options(const ListOptions& options) {
    Answer answer;
    for (const CLI::App* one : options.app->get_subcommands({})) {
        nlohmann::json rows = nlohmann::json::array();
        answer.text += fmt::format("{}: {}\n", one->get_name(), one->get_description());
        for (const app::OptionInfo& row : static_cast<const Command*>(one)->rows()) {
            rows.push_back(option_json(row));
            answer.text +=
                fmt::format("    {:<24}{}\n", row.name, app::option_types()[row.type].name);
        }
        answer.facts["commands"].push_back({{"name", one->get_name()},
                                            {"meaning", one->get_description()},
                                            {"options", std::move(rows)}});
    }
    return answer;
}

Answer listed(const ListOptions& options) {
    if (!options.markdown.empty()) {
        return write_pages(options);
    }
    if (!options.search.empty()) {
        return search(options.search);
    }
    if (options.what == "stages" || is_kind(options.what) || is_stage(options.what)) {
        return list_stages(options);
    }
    std::error_code ignored;
    if (options.what == "cameras" || is_built_in_camera(options.what) ||
        options.what.ends_with(".cam") || std::filesystem::is_regular_file(options.what, ignored)) {
        return list_cameras(options);
    }
    if (options.what == "options") {
        return list_options(options);
    }
    const std::vector<std::string> family = names_of(options.what);
    return family.empty() ? refuse_unknown(options) : list_found(family, family.size());
}

ExitCode list(const ListOptions& options) { return give(listed(options), options.manner); }

}  // namespace

void add_list_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, ListOptions& options) {
        options.what = "stages";
        options.app = command.get_parent();
        command.add<ListOptions>(
            {{option({.name = "WHAT",
                      .meaning = "'stages' (default), a kind of stages such as 'object "
                                 "generators', 'cameras', the name of a stage or a built-in "
                                 "camera, a family of these, a camera file (.cam), or 'options' "
                                 "(of all commands)"},
                     text(), &ListOptions::what),
              option({.name = "--search",
                      .others = {"--find"},
                      .placeholder = "WORDS",
                      .meaning = "the built-in cameras that words lead to, the best first"},
                     text(), &ListOptions::search),
              option({.name = "--markdown",
                      .placeholder = "FOLDER",
                      .meaning = "write the documentation pages of all stages to a folder, with "
                                 "the examples as camera files"},
                     text(OptionType::folder), &ListOptions::markdown),
              json_flag(&ListOptions::manner, "print the list as JSON")}},
            options);
        command.footer(
            "Examples:\n"
            "  balcony list                   all stages, one per line\n"
            "  balcony list direction_rules   the stages of one kind\n"
            "  balcony list superellipse      one stage with its parameters and its formula\n"
            "  balcony list cameras           the built-in cameras, by family\n"
            "  balcony list dome              those of a family\n"
            "  balcony list panorama          one of them with its parameters\n"
            "  balcony list --search \"flatten a room\"\n"
            "  balcony list my.cam            the cameras of a file");
    };
    add_command<ListOptions>(app, code, "list", "lists stages and cameras", list, describe);
}

}  // namespace balcony::cli
