// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>

#include "balcony/solving.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/solve_report.hpp"

namespace balcony::cli {

namespace {

struct SolveOptions {
    app::SolveRequest request;  ///< Without its files.
    std::string marks;
    std::string output;
    std::string drawing;
    std::string over;
    std::string uncertainty;
    Manner manner;
};

ExitCode solve(const SolveOptions& options) {
    Answer answer;
    answer.facts["output"] = nullptr;
    app::SolveRequest request = options.request;
    request.marks = options.marks;
    request.output = options.output;
    request.drawing = options.drawing;
    request.over = options.over;
    request.uncertainty = options.uncertainty;
    const Interruptible work;
    const auto solved = app::solve_camera(request, work.token());
    if (answer.add(solved.diagnostics)) {
        answer.facts = to_json(*solved);
        answer.facts["output"] =
            options.output.empty() ? nlohmann::json() : nlohmann::json(options.output);
        answer.facts["drawing"] =
            options.drawing.empty() ? nlohmann::json() : nlohmann::json(options.drawing);
        answer.facts["uncertainty_map"] =
            options.uncertainty.empty() ? nlohmann::json() : nlohmann::json(options.uncertainty);
        answer.text = to_text(*solved);
        for (const std::string& file : {options.output, options.drawing, options.uncertainty}) {
            answer.text += file.empty() ? "" : fmt::format("{}: written\n", printable(file));
        }
    }
    return give(answer, options.manner);
}

}  // namespace

void add_solve_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, SolveOptions& options) {
        app::Options<SolveOptions> all;
        all.add(&SolveOptions::request, {{camera_argument(&app::SolveRequest::camera)}});
        all.rows.push_back(option({.name = "--with",
                                   .others = {"--marks"},
                                   .placeholder = "FILE",
                                   .meaning = "file of marks (.yml): what the picture is to show, "
                                              "and which parameters are unknown",
                                   .required = true},
                                  text(OptionType::file), &SolveOptions::marks));
        all.rows.push_back(output_option(
            &SolveOptions::output,
            "camera file (.cam): the file of the camera with the values that were found in it; "
            "comments and layout are kept (default: the values are only shown)"));
        all.rows.push_back(
            option({.name = "--drawing",
                    .placeholder = "FILE",
                    .meaning = "a drawing (.svg, .png, .jpg, .webp, .tif) of the marks, of what "
                               "the constraints miss and of the uncertainty of projections"},
                   text(OptionType::file), &SolveOptions::drawing));
        all.rows.push_back(option({.name = "--over",
                                   .placeholder = "FILE",
                                   .meaning = "the photo or the rendering that was marked, which "
                                              "the drawing is put over"},
                                  text(OptionType::file), &SolveOptions::over));
        all.rows.push_back(
            option({.name = "--uncertainty",
                    .placeholder = "FILE",
                    .meaning = "a map (.png, .jpg, .webp, .tif) of the expected uncertainty of "
                               "projections, with lines of equal deviation"},
                   text(OptionType::file), &SolveOptions::uncertainty));
        all.add(&SolveOptions::request,
                {{app::set_option(&app::SolveRequest::set),
                  option({.name = "--starts",
                          .placeholder = "COUNT",
                          .meaning = "number of starts of the search: more than one are spread "
                                     "over the ranges of the unknown parameters"},
                         app::count(1, 1000), &app::SolveRequest::starts)}});
        all.add(manner_options(&SolveOptions::manner));
        command.add(std::move(all), options);
        command.footer(
            "Examples:\n"
            "  balcony solve my.cam:closeup --with marks.yml -o solved.cam\n"
            "  balcony solve my.cam:closeup --with marks.yml --set fov=40deg --json\n"
            "  balcony solve pinhole --with facade.yml --starts 8 -o photo.cam\n"
            "  balcony solve pinhole --with facade.yml --drawing misses.png --over photo.png\n"
            "  balcony render scene.glb --camera my.cam:closeup --solve marks.yml -o picture.png");
    };
    add_command<SolveOptions>(app, code, "solve",
                              "finds parameters of a camera by what its picture is to show", solve,
                              describe);
}

}  // namespace balcony::cli
