// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/lang.hpp"
#include "cli/command.hpp"
#include "cli/report.hpp"

namespace balcony::cli {

namespace {

using camera::ParameterType;
using camera::StageEntry;
using camera::StageParameter;

struct ListOptions {
    std::string what;
    bool json = false;
};

std::string type_text(const StageParameter& parameter) {
    const char* unit = parameter.unit == camera::Unit::angle ? "angle" : "number";
    switch (parameter.type) {
        case ParameterType::number: return unit;
        case ParameterType::pair: return "(a, b)";
        case ParameterType::size: return "number or (a, b)";
        case ParameterType::triple: return "(a, b, c)";
        case ParameterType::axis: return "x, y, z or (a, b, c)";
        case ParameterType::choice: return fmt::format("{}", fmt::join(parameter.choices, " | "));
        case ParameterType::curve: return "curve";
    }
    return {};
}

std::string default_text(const StageParameter& parameter) {
    if (!parameter.choices.empty()) {
        return std::string(parameter.choices.front());
    }
    const auto& values = parameter.default_value;
    return values.size() == 1 ? fmt::format("{}", values.front())
           : values.empty()   ? ""
                              : fmt::format("({})", fmt::join(values, ", "));
}

std::string call_text(const StageEntry& row) {
    if (row.formula) {
        return std::string(row.meaning.substr(row.meaning.find(row.name)));
    }
    std::vector<std::string_view> names;
    for (const StageParameter& parameter : row.parameters) {
        names.push_back(parameter.name);
    }
    return names.empty() ? std::string(row.name)
                         : fmt::format("{}({})", row.name, fmt::join(names, ", "));
}

void print_stage(const StageEntry& row) {
    fmt::print("{}: {}\n    {}\n", name_of(row.kind), call_text(row), row.meaning);
    for (const StageParameter& parameter : row.parameters) {
        const std::string standard = default_text(parameter);
        fmt::print("    {:<10} {}{}\n               {}\n", parameter.name, type_text(parameter),
                   standard.empty() ? "" : ", default " + standard, parameter.meaning);
    }
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
            {"parameters", parameters}};
}

void list_stages(bool json) {
    nlohmann::json all = nlohmann::json::array();
    std::optional<camera::StageKind> heading;
    for (const StageEntry& row : camera::catalogue()) {
        if (json) {
            all.push_back(stage_json(row));
            continue;
        }
        if (heading != row.kind) {
            fmt::print("{}{}s\n", heading ? "\n" : "", name_of(row.kind));
            heading = row.kind;
        }
        fmt::print("  {:<14} {}\n", row.name, row.meaning);
    }
    if (json) {
        fmt::print("{}\n", all.dump(2));
    }
}

// The cameras that a file has, or the standard ones with their files' own comments.
Result<std::vector<lang::CameraDescription>> cameras_of(const std::string& file) {
    if (file != "cameras") {
        return lang::describe(file);
    }
    std::vector<lang::CameraDescription> all;
    for (const std::string& name : lang::standard_cameras()) {
        auto described = lang::describe(name);
        if (!described) {
            return described;
        }
        all.insert(all.end(), described->begin(), described->end());
    }
    return all;
}

ExitCode list_cameras(const ListOptions& options) {
    const auto cameras = cameras_of(options.what);
    if (!options.json) {
        report(cameras.diagnostics);
    }
    if (!cameras) {
        return ExitCode::bad_input;
    }
    nlohmann::json all = nlohmann::json::array();
    for (const lang::CameraDescription& described : *cameras) {
        std::vector<std::string> parameters;
        nlohmann::json parameter_list = nlohmann::json::array();
        for (const auto& parameter : described.parameters) {
            parameters.push_back(parameter.name + " = " + parameter.default_text);
            parameter_list.push_back(
                {{"name", parameter.name}, {"default", parameter.default_text}});
        }
        if (options.json) {
            all.push_back({{"name", described.name},
                           {"comment", described.comment},
                           {"parameters", parameter_list}});
            continue;
        }
        fmt::print("{}({})\n", described.name, fmt::join(parameters, ", "));
        if (!described.comment.empty()) {
            fmt::print("    {}\n", described.comment.substr(0, described.comment.find('\n')));
        }
    }
    if (options.json) {
        fmt::print("{}\n", all.dump(2));
    }
    return ExitCode::done;
}

ExitCode list(const ListOptions& options) {
    if (options.what == "stages") {
        list_stages(options.json);
        return ExitCode::done;
    }
    if (options.what == "cameras" || options.what.ends_with(".cam")) {
        return list_cameras(options);
    }
    std::vector<std::string> known{"stages", "cameras"};
    bool found = false;
    nlohmann::json all = nlohmann::json::array();
    for (const StageEntry& row : camera::catalogue()) {
        known.emplace_back(row.name);
        if (row.name == options.what) {
            if (options.json) {
                all.push_back(stage_json(row));
            } else {
                print_stage(row);
            }
            found = true;
        }
    }
    if (!found) {
        const auto nearest = nearest_name(options.what, known);
        report({error(fmt::format("there is nothing named '{}' to list", options.what), {},
                      nearest ? fmt::format("did you mean '{}'?", *nearest)
                              : "balcony list stages, balcony list cameras, balcony list zoom")});
        return ExitCode::wrong_usage;
    }
    if (options.json) {
        fmt::print("{}\n", all.dump(2));
    }
    return ExitCode::done;
}

}  // namespace

void add_list_command(CLI::App& app, ExitCode& code) {
    auto* command = app.add_subcommand("list", "lists stages and cameras");
    const auto options = std::make_shared<ListOptions>();
    options->what = "stages";
    command->add_option("WHAT", options->what,
                        "'stages', 'cameras', the name of a stage, or a camera file (.cam)");
    command->add_flag("--json", options->json, "for programs");
    command->footer(
        "Examples:\n"
        "  balcony list                   all stages, a line each\n"
        "  balcony list superellipse      one stage with its parameters\n"
        "  balcony list cameras           the cameras that come along\n"
        "  balcony list gallery.cam       the cameras of a file");
    command->callback([options, &code] { code = list(*options); });
}

}  // namespace balcony::cli
