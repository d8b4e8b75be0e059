// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands/command.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/explain_report.hpp"
#include "cli/report/json.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

struct ExplainOptions {
    std::string camera;
    std::vector<std::string> set;
    PictureSize size;
    bool json = false;
};

// Prints the text, or adds the same facts to the JSON document.
ExitCode explain(const CameraArgument& wanted, const PictureSize& size, bool as_json,
                 nlohmann::json& document, Diagnostics& diagnostics) {
    const auto made = lang::Workspace().explain(wanted.file, wanted.name, wanted.overrides);
    diagnostics.insert(diagnostics.end(), made.diagnostics.begin(), made.diagnostics.end());
    if (!made) {
        return ExitCode::bad_input;
    }
    const auto& [picture, explanation] = *made;
    const auto [width, height] = size.resolve(picture.aspect(), picture.parts().size);
    const std::string formulas = formulas_text(
        picture.with_fit(size.fit), static_cast<double>(width), static_cast<double>(height));
    if (as_json) {
        document = explanation_json(explanation);
        document["width"] = width;
        document["height"] = height;
        document["formulas"] = formulas;
    } else {
        print_result(fmt::format(
            "{}\nFormulas for a picture of {} x {} pixels. x and y are the position in pixels from "
            "the\n"
            "top left corner, t is the time{}:\n\n{}",
            explanation_text(explanation), width, height,
            explanation.is_picture ? ", a coverage is the opacity at the position" : "", formulas));
    }
    return ExitCode::done;
}

ExitCode explain(const ExplainOptions& options) {
    const Result<CameraArgument> wanted = read_camera(options.camera, options.set);
    Diagnostics diagnostics = wanted.diagnostics;
    nlohmann::json document = nlohmann::json::object();
    const ExitCode code = wanted
                              ? explain(*wanted, options.size, options.json, document, diagnostics)
                              : ExitCode::bad_input;
    if (options.json) {
        document["diagnostics"] = to_json(diagnostics);
        print_json(document);
    } else {
        report(diagnostics);
    }
    return code;
}

}  // namespace

void add_explain_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, ExplainOptions& options) {
        app::Options<ExplainOptions> all{
            {camera_argument(&ExplainOptions::camera), app::set_option(&ExplainOptions::set)}};
        all.add(&ExplainOptions::size,
                app::size_options("size of the picture in pixels for which the formulas are "
                                  "valid"));
        all.add(&ExplainOptions::size, app::aspect_options());
        all.rows.push_back(json_flag(&ExplainOptions::json, "print the description as JSON"));
        command.add(std::move(all), options);
        command.footer(
            "Examples:\n  balcony explain superelliptic\n  balcony explain my.cam:closeup");
    };
    add_command<ExplainOptions>(app, code, "explain",
                                "describes a camera or a picture in words and formulas", explain,
                                describe);
}

}  // namespace balcony::cli
