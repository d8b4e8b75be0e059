// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/camera_argument.hpp"
#include "cli/command.hpp"
#include "cli/json.hpp"
#include "cli/render_options.hpp"
#include "cli/report.hpp"

namespace balcony::cli {

namespace {

struct ExplainOptions {
    std::string camera;
    std::vector<std::string> set;
    std::string size;
    bool json = false;
};

// The ray as formulas of the picture point, as they are computed.
std::string formulas_of(const camera::Camera& camera, std::size_t width, std::size_t height) {
    expr::Graph graph;
    const camera::RayExpressions ray =
        camera.emit(graph, static_cast<double>(width), static_cast<double>(height));
    const std::array roots{ray.parameters.u, ray.parameters.v, ray.origin.x,
                           ray.origin.y,     ray.origin.z,     ray.direction.x,
                           ray.direction.y,  ray.direction.z,  ray.valid};
    const std::array<std::string, 9> names{"u",           "v",           "origin_x",
                                           "origin_y",    "origin_z",    "direction_x",
                                           "direction_y", "direction_z", "valid"};
    return expr::print(expr::simplify(roots), names);
}

std::string text_of(const lang::Explanation& explanation) {
    std::string text = fmt::format("{}: {}\n", explanation.name, explanation.summary);
    for (const auto& parameter : explanation.parameters) {
        text += fmt::format("    {} = {}\n", parameter.name, parameter.value);
    }
    text += "\nA point of the picture becomes a ray in these steps:\n";
    for (const lang::Explanation::Step& step : explanation.steps) {
        const std::string indent(4 * (step.depth + 1), ' ');
        text += fmt::format("{}{:<7} {}\n", indent, step.statement, step.written);
        for (const std::string& meaning : step.meanings) {
            text += fmt::format("{}        - {}\n", indent, meaning);
        }
    }
    return text;
}

nlohmann::json json_of(const lang::Explanation& explanation) {
    nlohmann::json parameters = nlohmann::json::array();
    for (const auto& parameter : explanation.parameters) {
        parameters.push_back({{"name", parameter.name}, {"value", parameter.value}});
    }
    nlohmann::json steps = nlohmann::json::array();
    for (const lang::Explanation::Step& step : explanation.steps) {
        steps.push_back({{"statement", step.statement},
                         {"written", step.written},
                         {"meanings", step.meanings},
                         {"depth", step.depth}});
    }
    return {{"camera", explanation.name},
            {"summary", explanation.summary},
            {"parameters", parameters},
            {"steps", steps}};
}

// Text to standard output, or the same as JSON in the document.
ExitCode explain_camera(const CameraArgument& wanted, const PictureSize& size, bool as_json,
                        nlohmann::json& document, Diagnostics& said) {
    const auto camera = lang::load_camera(wanted.file, wanted.name, wanted.overrides);
    said.insert(said.end(), camera.diagnostics.begin(), camera.diagnostics.end());
    const auto explanation = lang::explain(wanted.file, wanted.name, wanted.overrides);
    if (!camera || !explanation) {
        return ExitCode::bad_input;
    }
    const auto [width, height] = size.resolve(camera->parts().aspect);
    const std::string formulas = formulas_of(*camera, width, height);
    if (as_json) {
        document = json_of(*explanation);
        document["formulas"] = formulas;
    } else {
        print_result(
            fmt::format("{}\nFormulas, for a picture of {} x {} pixels; picture_x and picture_y "
                        "are the point in\n"
                        "pixels from the top left, t is time:\n\n{}",
                        text_of(*explanation), width, height, formulas));
    }
    return ExitCode::done;
}

ExitCode explain(const ExplainOptions& options) {
    Diagnostics said;
    ExitCode code = ExitCode::bad_input;
    nlohmann::json document = nlohmann::json::object();
    const PictureSize size = read_size(options.size, said);
    const Result<CameraArgument> wanted = read_camera(options.camera, options.set);
    if (has_errors(said)) {
        code = ExitCode::wrong_usage;
    } else if (!wanted) {
        said = wanted.diagnostics;
    } else {
        code = explain_camera(*wanted, size, options.json, document, said);
    }
    if (options.json) {
        document["diagnostics"] = to_json(said);
        print_json(document);
    } else {
        report(said);
    }
    return code;
}

}  // namespace

void add_explain_command(CLI::App& app, ExitCode& code) {
    auto* command = app.add_subcommand("explain", "says in words and formulas what a camera does");
    command->group("Commands");
    const auto options = std::make_shared<ExplainOptions>();
    command
        ->add_option("CAMERA", options->camera,
                     "a camera file or its camera NAME (the last if not said), or a camera of "
                     "'balcony list cameras'")
        ->type_name("FILE[:NAME]")
        ->required();
    add_set_option(*command, options->set);
    command->add_option("--size", options->size, "the picture's size, which the formulas hold for")
        ->type_name("WxH");
    command->add_flag("--json", options->json, "for programs");
    command->footer("Examples:\n  balcony explain superelliptic\n  balcony explain my.cam:closeup");
    command->callback([options, &code] { code = explain(*options); });
}

}  // namespace balcony::cli
