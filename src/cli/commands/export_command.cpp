// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "balcony/camera_export.hpp"
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

std::string target_names(bool with_inverse = false) {
    std::string names;
    for (const ExportTarget& target : bridge::export_targets()) {
        if (target.has_inverse || !with_inverse) {
            names += fmt::format("{}{}", names.empty() ? "" : ", ", target.name);
        }
    }
    return names;
}

// That of --to, or else the first one whose files end as the output does.
void choose_target(CameraExportOptions& options, const app::GivenWords& given, Diagnostics& found) {
    if (given.contains("--to")) {
        options.target = bridge::find_export_target(options.to);
        return;
    }
    for (const ExportTarget& target : bridge::export_targets()) {
        if (options.target == nullptr && !options.output.empty() &&
            ending_of(options.output) == target.ending) {
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
                  "omit --inverse, or use --to with one of " + target_names(true)));
    }
}

// The parameters that stay open; nothing for all of them.
std::optional<std::vector<std::string>> open_parameters(const CameraExportOptions& options) {
    return options.parameters == "auto" ? app::parameters_for(*options.target)
                                        : open_names(options.parameters);
}

std::string title_of(const CameraExportOptions& options) {
    std::string title = options.camera;
    for (const std::string& value : options.set) {
        title += " --set " + value;
    }
    return title;
}

nlohmann::json precision_json(const bridge::SinglePrecision& found) {
    return {{"rays", found.rays},        {"lost", found.lost}, {"largest_pixels", found.largest},
            {"p99_pixels", found.usual}, {"x", found.x},       {"y", found.y}};
}

Result<app::CameraExport> make_export(const CameraExportOptions& options,
                                      lang::Workspace& workspace) {
    const Result<app::CameraArgument> wanted = app::read_camera(options.camera, options.set);
    if (!wanted) {
        return wanted.diagnostics;
    }
    const Result<lang::OpenCamera> opened = workspace.make_open_camera(
        wanted->file, wanted->name, wanted->overrides, open_parameters(options));
    if (!opened) {
        return opened.diagnostics;
    }
    const auto [width, height] = options.size.resolve(opened->camera.parts().aspect);
    Result<app::CameraExport> made = app::export_camera(
        *opened, {.target = options.target,
                  .title = title_of(options),
                  .comment = app::comment_of(workspace, wanted->file, opened->camera.name()),
                  .single = options.precision == "single",
                  .inverse = options.inverse,
                  .axes = options.axes,
                  .size = {width, height}});
    made.diagnostics.insert(made.diagnostics.begin(), opened.diagnostics.begin(),
                            opened.diagnostics.end());
    return made;
}

// The text that the camera becomes.
std::string make_text(const CameraExportOptions& options, Answer& answer) {
    lang::Workspace workspace;
    Result<app::CameraExport> made = make_export(options, workspace);
    if (!answer.add(made.diagnostics) ||
        !answer.add(app::check_overwrites(options.output, workspace.files()))) {
        return {};
    }
    answer.facts["parameters"] = {{"open", made->open}, {"closed", made->closed}};
    std::string precision;
    if (const auto& found = made->single) {
        answer.facts["single_precision"] = precision_json(*found);
        precision =
            fmt::format("; single precision moves rays by {:.1g} pixels at most", found->largest);
    }
    answer.text = fmt::format("{}: exported{}\n", printable(options.output), precision);
    return std::move(made->text);
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
                   .meaning = fmt::format("also write a function from points in space to positions "
                                          "in the picture ({})",
                                          target_names(true))},
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
