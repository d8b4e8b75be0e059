// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/images.hpp"
#include "balcony/povray.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/options/common_options.hpp"
#include "cli/options/option_values.hpp"
#include "cli/options/picture_output.hpp"
#include "cli/report/json.hpp"
#include "cli/report/peak_memory.hpp"
#include "cli/report/progress_display.hpp"
#include "cli/report/render_report.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

struct PovOptions {
    std::string scene;
    std::string camera;
    std::string output;
    std::vector<std::string> set;
    SizeWords size;
    std::string samples = "16";
    std::string seed = "0";
    std::string time = "0";
    std::string axes = "y_up";
    std::vector<std::string> povray;
    bool quiet = false;
    bool json = false;
};

struct PovRequest {
    bridge::PovraySettings settings;
    PictureSize size;
    PictureOutput output;
};

PovRequest read_pov_request(const PovOptions& options, Diagnostics& diagnostics) {
    const fs::path file = options.output.empty()
                              ? fs::path(fs::path(options.scene).stem().string() + ".png")
                              : fs::path(options.output);
    PovRequest request{{}, read_size(options.size, diagnostics), PictureOutput(file)};
    bridge::PovraySettings& settings = request.settings;
    constexpr double largest_time = 1e12;
    settings.samples = read_count("--samples", options.samples, 1, 65'536, diagnostics);
    settings.seed = static_cast<std::uint32_t>(read_count(
        "--seed", options.seed, 0, std::numeric_limits<std::uint32_t>::max(), diagnostics));
    settings.time = read_number("--time", options.time, -largest_time, largest_time,
                                "give a number", diagnostics);
    std::vector<std::string> axes;
    for (const bridge::PovrayAxes& row : bridge::povray_axes()) {
        axes.emplace_back(row.name);
    }
    check_name("--axes", options.axes, axes, diagnostics);
    settings.axes = options.axes;
    settings.options = options.povray;
    settings.unclipped = request.output.display_format() == nullptr;
    return request;
}

ExitCode check_pov_files(const PovOptions& options, const PictureOutput& output,
                         Diagnostics& diagnostics) {
    for (const fs::path& input : {fs::path(options.scene), camera_file(options.camera)}) {
        std::error_code failed;
        if (fs::equivalent(input, output.file(), failed) && !failed) {
            diagnostics.push_back(
                error(fmt::format("'{}' is an input and would be overwritten", output.name()), {},
                      "name another picture with --output"));
            return ExitCode::wrong_usage;
        }
    }
    return output.check(diagnostics);
}

std::size_t transparent_pixels(const render::Film& film) {
    std::size_t count = 0;
    for (std::size_t y = 0; y < film.height; ++y) {
        for (std::size_t x = 0; x < film.width; ++x) {
            count += film.pixel(x, y).a <= 0.0F ? 1 : 0;
        }
    }
    return count;
}

void describe_pov(RenderReport& outcome, const PovRequest& request, const camera::Picture& picture,
                  const render::Film& film, const bridge::PovrayProgram& program,
                  const bridge::PovraySummary& summary) {
    const std::size_t transparent = transparent_pixels(film);
    if (transparent > 0) {
        outcome.diagnostics.push_back(
            warning(fmt::format("no camera has a ray at {} of {} pixels; they are transparent",
                                transparent, film.window.size())));
    }
    warn_of_lost_alpha(outcome, film, request.output);
    const bool interrupted = summary.end == bridge::PovrayEnd::interrupted;
    outcome.facts = {{"output", nullptr},
                     {"camera", picture.name()},
                     {"width", film.width},
                     {"height", film.height},
                     {"passes", film.passes.front()},
                     {"rays", summary.camera_rays},
                     {"single_rays", summary.single_rays},
                     {"faces", summary.faces},
                     {"largest_error", summary.largest_error},
                     {"povray", program.version},
                     {"povray_runs", summary.runs},
                     {"povray_seconds", summary.povray_seconds},
                     {"camera_seconds", summary.camera_seconds},
                     {"peak_memory", peak_memory()},
                     {"interrupted", interrupted}};
    outcome.sentence = fmt::format(
        "{}{}: {} x {} pixels through '{}', {}, {} rays; POV-Ray {} ran {} for {}\n",
        interrupted ? "interrupted; the partial picture is " : "", printable(request.output.name()),
        film.width, film.height, picture.name(), counted(film.passes.front(), "pass", "passes"),
        count_text(static_cast<double>(summary.camera_rays)), program.version,
        summary.runs == 1 ? "once" : fmt::format("{} times", summary.runs),
        duration_text(summary.povray_seconds));
}

ExitCode code_of(bridge::PovrayEnd end) {
    switch (end) {
        case bridge::PovrayEnd::done: return ExitCode::done;
        case bridge::PovrayEnd::interrupted: return ExitCode::interrupted;
        case bridge::PovrayEnd::bad_input: return ExitCode::bad_input;
        case bridge::PovrayEnd::environment: break;
    }
    return ExitCode::environment;
}

void render_pov_picture(const PovOptions& options, RenderReport& outcome) {
    const auto fail = [&outcome](ExitCode code, const Diagnostics& diagnostics = {}) {
        add(outcome, diagnostics);
        outcome.code = code;
    };
    PovRequest request = read_pov_request(options, outcome.diagnostics);
    if (has_errors(outcome.diagnostics)) {
        return fail(ExitCode::wrong_usage);
    }
    if (const ExitCode code = check_pov_files(options, request.output, outcome.diagnostics);
        code != ExitCode::done) {
        return fail(code);
    }
    Result<camera::Picture> picture = load_picture(options.camera, options.set);
    add(outcome, picture.diagnostics);
    if (!picture) {
        return fail(ExitCode::bad_input);
    }
    *picture = picture->with_fit(request.size.fit);
    const auto [width, height] = request.size.resolve(picture->aspect(), picture->parts().size);
    Result<render::Film> film =
        render::make_film({.width = width, .height = height, .data_layers = false});
    if (!film) {
        return fail(ExitCode::bad_input, film.diagnostics);
    }
    const Result<bridge::PovrayProgram> program = bridge::find_povray();
    if (!program) {
        return fail(ExitCode::environment, program.diagnostics);
    }
    // POV-Ray writes images, whatever becomes of them.
    if (const Diagnostics missing = images::require(); has_errors(missing)) {
        return fail(ExitCode::environment, missing);
    }
    const Job interruption;
    ProgressDisplay display(options.quiet || options.json);
    const bridge::PovraySummary summary = bridge::render_with_povray(
        *program, options.scene, *picture, request.settings, *film,
        [&](const render::Progress& progress) { display.show(progress); }, interruption.token());
    display.clear();
    fail(code_of(summary.end), summary.diagnostics);
    if (has_errors(summary.diagnostics)) {
        return;
    }
    if (film->passes.front() == 0) {
        outcome.sentence = "interrupted before there was anything to save\n";
        return;
    }
    describe_pov(outcome, request, *picture, *film, *program, summary);
    // POV-Ray's picture is meant for the display as it is.
    if (const Diagnostics failed =
            request.output.write(*film, {.view = render::ViewTransform::standard, .dither = false});
        has_errors(failed)) {
        return fail(ExitCode::environment, failed);
    }
    outcome.facts["output"] = request.output.is_stream() ? "-" : request.output.file().string();
}

ExitCode pov(const PovOptions& options) {
    RenderReport outcome;
    render_pov_picture(options, outcome);
    if (options.json) {
        print_json(json_of(outcome));
        return outcome.code;
    }
    report(outcome.diagnostics);
    if (!options.quiet && !has_errors(outcome.diagnostics)) {
        if (options.output == "-") {
            print_aside(outcome.sentence);
        } else {
            print_result(outcome.sentence);
        }
    }
    return outcome.code;
}

std::string axes_help() {
    std::vector<std::string> rows;
    for (const bridge::PovrayAxes& row : bridge::povray_axes()) {
        rows.push_back(fmt::format("{} ({})", row.name, row.meaning));
    }
    return fmt::format("axes of the scene: {}", fmt::join(rows, "; "));
}

}  // namespace

void add_pov_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](CLI::App& command, PovOptions& options) {
        command.add_option("SCENE.pov", options.scene, "scene file of POV-Ray")
            ->type_name("")
            ->required();
        command
            .add_option("-c,--camera", options.camera,
                        "camera: FILE, FILE:NAME, or the name of a built-in camera")
            ->type_name("CAMERA")
            ->required();
        command
            .add_option("-o,--output", options.output,
                        "picture file: .png, .jpg, .webp, .tif, or .exr for unclipped light; - is "
                        "standard output (default: the scene's name with .png, in this folder)")
            ->type_name("FILE");
        add_set_option(command, options.set);
        add_size_options(command, options.size, "size of the picture in pixels");
        add_aspect_option(command, options.size);
        const auto value = [&](const char* names, std::string& text, const std::string& meaning,
                               const char* type) {
            command.add_option(names, text, meaning)->type_name(type)->capture_default_str();
        };
        value("-s,--samples", options.samples, "rays per pixel, evenly spread over its square",
              "COUNT");
        value("--seed", options.seed, "another number gives a lens other points", "NUMBER");
        value("--time", options.time, "t in the camera's formulas, and POV-Ray's clock", "T");
        value("--axes", options.axes, axes_help(), "AXES");
        command
            .add_option("OPTION", options.povray,
                        "options for POV-Ray itself, after --, such as +Q5 or Declare=Night=1")
            ->type_name("");
        add_quiet_option(command, options.quiet);
        command.add_flag("--json", options.json, "print file name, counts and diagnostics as JSON");
        command.footer(
            "Examples:\n"
            "  balcony pov scene.pov --camera superelliptic -o walls.png\n"
            "  balcony pov scene.pov --camera my.cam:poster --size 1920 -s 4 -o poster.png\n"
            "  balcony pov scene.pov --camera panorama --time 0.5 -o frame.png -- +Q8 "
            "Declare=Night=1");
    };
    add_command<PovOptions>(app, code, "pov",
                            "renders a scene of POV-Ray through a camera, with POV-Ray", pov,
                            describe);
}

}  // namespace balcony::cli
