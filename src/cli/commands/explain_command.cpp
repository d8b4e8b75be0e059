// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/commands/command.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/explain_report.hpp"

namespace balcony::cli {

namespace {

struct ExplainOptions {
    std::string camera;
    std::vector<std::string> set;
    SizeRequest size;
    Manner manner;
};

void explain(const app::CameraArgument& wanted, const SizeRequest& size, Answer& answer) {
    const auto made = lang::Workspace().explain(wanted.file, wanted.name, wanted.overrides);
    if (!answer.add(made.diagnostics)) {
        return;
    }
    const auto& [picture, explanation] = *made;
    const auto [width, height] = size.resolve(picture.aspect(), picture.parts().size);
    const std::string formulas = formulas_text(
        picture.with_fit(size.fit), static_cast<double>(width), static_cast<double>(height));
    answer.facts = explanation_json(explanation);
    answer.facts["width"] = width;
    answer.facts["height"] = height;
    answer.facts["formulas"] = formulas;
    answer.text = explanation_text(explanation, formulas, width, height);
}

ExitCode explain(const ExplainOptions& options) {
    const Result<app::CameraArgument> wanted = app::read_camera(options.camera, options.set);
    Answer answer;
    if (answer.add(wanted.diagnostics)) {
        explain(*wanted, options.size, answer);
    }
    return give(answer, options.manner);
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
        all.rows.push_back(json_flag(&ExplainOptions::manner, "print the description as JSON"));
        command.add(std::move(all), options);
        command.footer(
            "Examples:\n  balcony explain superelliptic\n  balcony explain my.cam:closeup");
    };
    add_command<ExplainOptions>(app, code, "explain",
                                "describes a camera or a picture in words and formulas", explain,
                                describe);
}

}  // namespace balcony::cli
