// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "balcony/export.hpp"
#include "balcony/inputs.hpp"
#include "balcony/lang.hpp"
#include "balcony/output_file.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/command_rows.hpp"

namespace balcony::cli {

namespace {

using bridge::ExportTarget;

struct CameraExportOptions {
    std::string camera;
    std::string to;
    std::string output;
    std::vector<std::string> set;
    std::string parameters = "auto";
    std::string precision = "double";
    bool inverse = false;
    std::optional<Axes> axes;
    SizeRequest size;
    Manner manner;
    const ExportTarget* target = nullptr;  ///< Of these words.
};

std::vector<app::OptionChoice> targets() {
    std::vector<app::OptionChoice> made;
    for (const ExportTarget& target : bridge::export_targets()) {
        made.push_back({std::string(target.name), std::string(target.meaning)});
    }
    return made;
}

std::string target_names() {
    std::string names;
    for (const ExportTarget& target : bridge::export_targets()) {
        names += fmt::format("{}{}", names.empty() ? "" : ", ", target.name);
    }
    return names;
}

// That of --to, or else the one whose files end as the output does.
void choose_target(CameraExportOptions& options, const app::GivenWords& given, Diagnostics& found) {
    if (given.contains("--to")) {
        options.target = bridge::find_export_target(options.to);
        return;
    }
    for (const ExportTarget& target : bridge::export_targets()) {
        if (!options.output.empty() && ending_of(options.output) == target.ending) {
            options.target = &target;
        }
    }
    if (options.target == nullptr) {
        found.push_back(error(Kind::usage, "what the camera is exported to is not known",
                              "add --to and one of " + target_names()));
    }
}

void check_inverse(CameraExportOptions& options, const app::GivenWords&, Diagnostics& found) {
    if (options.inverse && options.target != nullptr && !options.target->has_inverse) {
        found.push_back(
            error(Kind::usage,
                  fmt::format("a camera in the language {} finds no points", options.target->name),
                  "omit --inverse, or use --to c or --to numpy"));
    }
}

// The parameters that stay open; nothing for all of them.
std::optional<std::vector<std::string>> open_names(const CameraExportOptions& options) {
    const bool all = options.parameters == "all" ||
                     (options.parameters == "auto" && options.target->opens_parameters);
    if (all) {
        return std::nullopt;
    }
    std::vector<std::string> names;
    if (options.parameters == "auto" || options.parameters == "none") {
        return names;
    }
    std::string_view rest = options.parameters;
    while (!rest.empty()) {
        const std::size_t comma = rest.find(',');
        names.emplace_back(rest.substr(0, comma));
        rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
    }
    return names;
}

std::string comment_of(lang::Workspace& workspace, const app::CameraArgument& wanted,
                       const std::string& camera) {
    const auto described = workspace.describe(wanted.file);
    if (described) {
        for (const lang::Description& description : *described) {
            if (description.name == camera) {
                return description.comment;
            }
        }
    }
    return {};
}

std::string title_of(const CameraExportOptions& options) {
    std::string title = options.camera;
    for (const std::string& value : options.set) {
        title += " --set " + value;
    }
    return title;
}

struct ReadyCamera {
    bridge::ExportSource source;
    std::vector<std::string> closed;
};

Result<ReadyCamera> load(const CameraExportOptions& options, lang::Workspace& workspace) {
    const Result<app::CameraArgument> wanted = app::read_camera(options.camera, options.set);
    if (!wanted) {
        return wanted.diagnostics;
    }
    Result<lang::OpenCamera> opened = workspace.make_open_camera(
        wanted->file, wanted->name, wanted->overrides, open_names(options));
    if (!opened) {
        return std::move(opened.diagnostics);
    }
    ReadyCamera made{{opened->camera,
                      {},
                      title_of(options),
                      comment_of(workspace, *wanted, opened->camera.name())},
                     std::move(opened->closed)};
    for (const lang::OpenParameter& parameter : opened->open) {
        made.source.parameters.push_back({parameter.name, lang::parameter_input(parameter.name),
                                          parameter.written, parameter.value, parameter.is_angle});
    }
    if (opened->camera.parts().time) {
        opened.diagnostics.push_back(
            warning(fmt::format("the rays of the camera '{}' have times of their own, which other "
                                "programs do not know",
                                opened->camera.name()),
                    {}, "all of a picture is seen at the time of that program"));
    }
    return {std::move(made), std::move(opened.diagnostics)};
}

constexpr double visible = 0.1;  // Pixels.

void judge(const bridge::SinglePrecision& found, Diagnostics& diagnostics) {
    if (found.largest > visible) {
        diagnostics.push_back(warning(
            fmt::format("in single precision, rays move by up to {:.2g} pixels (at x = {}, y = {}; "
                        "99 % move by less than {:.2g})",
                        found.largest, found.x, found.y, found.usual),
            {},
            "move the camera's world closer to the origin, or use a target with double "
            "precision"));
    }
    if (found.lost > 0) {
        diagnostics.push_back(warning(fmt::format(
            "in single precision, {} of {} rays are there that are not in double precision, or the "
            "other way round",
            found.lost, found.rays)));
    }
}

nlohmann::json precision_json(const bridge::SinglePrecision& found) {
    return {{"rays", found.rays},        {"lost", found.lost}, {"largest_pixels", found.largest},
            {"p99_pixels", found.usual}, {"x", found.x},       {"y", found.y}};
}

// The text that the camera becomes.
std::string make_text(const CameraExportOptions& options, Answer& answer) {
    lang::Workspace workspace;
    const Result<ReadyCamera> ready = load(options, workspace);
    if (!answer.add(ready.diagnostics) ||
        !answer.add(app::check_overwrites(options.output, workspace.files()))) {
        return {};
    }
    bridge::ExportOptions wanted;
    wanted.single = options.precision == "single" || options.target->always_single;
    wanted.inverse = options.inverse;
    wanted.axes = options.axes;
    if (wanted.single) {
        const auto [width, height] = options.size.resolve(ready->source.camera.parts().aspect);
        wanted.judged_in = {width, height};
    }
    Result<bridge::ExportedCamera> exported =
        bridge::export_camera(*options.target, ready->source, wanted);
    if (!answer.add(exported.diagnostics)) {
        return {};
    }
    nlohmann::json open = nlohmann::json::array();
    for (const bridge::ExportParameter& parameter : ready->source.parameters) {
        open.push_back(parameter.name);
    }
    answer.facts["parameters"] = {{"open", open}, {"closed", ready->closed}};
    std::string precision;
    if (const auto& found = exported->single) {
        judge(*found, answer.diagnostics);
        answer.facts["single_precision"] = precision_json(*found);
        precision =
            fmt::format("; single precision moves rays by {:.1g} pixels at most", found->largest);
    }
    answer.text = fmt::format("{}: exported{}\n", printable(options.output), precision);
    return std::move(exported->text);
}

ExitCode export_camera(const CameraExportOptions& options) {
    const bool to_file = !options.output.empty();
    Answer answer;
    answer.facts = {{"target", options.target->name}, {"output", nullptr}};
    if (to_file && !answer.add(OutputFile::check(options.output))) {
        return give(answer, options.manner);
    }
    const std::string text = make_text(options, answer);
    if (answer.is_done() && to_file && answer.add(write_whole(options.output, text))) {
        answer.facts["output"] = options.output;
    } else if (answer.is_done() && !to_file) {
        answer.facts["text"] = text;
        answer.text = text;
        answer.print = print_file;
    }
    answer.text = answer.is_done() ? answer.text : "";
    return give(answer, {to_file && options.manner.quiet, options.manner.json});
}

std::string target_list() {
    std::string text;
    for (const ExportTarget& target : bridge::export_targets()) {
        text += fmt::format("  {:<8}{}\n", target.name, target.meaning);
    }
    return text;
}

}  // namespace

void add_export_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, CameraExportOptions& options) {
        app::Options<CameraExportOptions> all{
            {camera_argument(&CameraExportOptions::camera),
             option({.name = "--to",
                     .placeholder = "LANGUAGE",
                     .meaning =
                         fmt::format("the language, one of {}; without it, that of the output file",
                                     target_names())},
                    app::choice(targets()), &CameraExportOptions::to),
             output_option(&CameraExportOptions::output,
                           "output file; without it, the text goes to standard output"),
             app::set_option(&CameraExportOptions::set),
             option({.name = "--parameters",
                     .placeholder = "NAMES",
                     .meaning = "the camera's parameters that stay open: all, none, or names with "
                                "commas between them (default: what suits the language)",
                     .shows_fallback = false},
                    text(), &CameraExportOptions::parameters),
             option({.name = "--precision",
                     .placeholder = "PRECISION",
                     .meaning = "single or double, where both exist (c)"},
                    app::choice(std::vector<app::OptionChoice>{{"single"}, {"double"}},
                                "give single or double"),
                    &CameraExportOptions::precision),
             flag({.name = "--inverse",
                   .meaning = "also write a function from points in space to positions in the "
                              "picture (c, numpy)"},
                  true, &CameraExportOptions::inverse),
             axes_option(&CameraExportOptions::axes,
                         "the world of the rays: z_up or y_up (default: the camera's own, or y_up "
                         "for pov)")}};
        all.add(&CameraExportOptions::size,
                app::size_options("size in pixels of the picture that single precision is judged "
                                  "in; the text is good for any size"));
        all.add(manner_options(&CameraExportOptions::manner,
                               "print file name, facts and diagnostics as JSON"));
        all.checks.emplace_back(choose_target);
        all.checks.emplace_back(check_inverse);
        command.add(std::move(all), options);
        command.footer(
            "Languages:\n" + target_list() +
            "\nExamples:\n"
            "  balcony export superelliptic --to c -o superelliptic.c\n"
            "  balcony export my.cam:closeup -o closeup.osl\n"
            "  balcony export panorama --inverse -o panorama.py\n"
            "  balcony export my.cam:closeup --to c --precision single --parameters all");
    };
    add_command<CameraExportOptions>(app, code, "export",
                                     "writes a camera as a function or shader of another language",
                                     export_camera, describe);
}

}  // namespace balcony::cli
