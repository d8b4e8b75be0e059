// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "balcony/app.hpp"
#include "balcony/images.hpp"
#include "balcony/inputs.hpp"
#include "balcony/povray.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/options/picture_output.hpp"
#include "cli/report/json.hpp"
#include "cli/report/peak_memory.hpp"
#include "cli/report/render_observer.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

struct PovOptions {
    std::string scene;
    std::string camera;
    std::string output;
    std::vector<std::string> set;
    PictureSize size;
    bridge::PovraySettings settings;
    bool quiet = false;
    bool json = false;
};

struct PovRequest {
    bridge::PovraySettings settings;
    PictureSize size;
    app::Finish finish;
};

/// What there is to say of a picture, as text or JSON.
struct PovReport {
    Diagnostics diagnostics;
    bool interrupted = false;
    nlohmann::json facts = nlohmann::json::object();
    std::string sentence;
};

PovRequest pov_request(const PovOptions& options) {
    const fs::path file = options.output.empty()
                              ? fs::path(fs::path(options.scene).stem().string() + ".png")
                              : fs::path(options.output);
    PovRequest request{options.settings, options.size, {.output = file}};
    // POV-Ray's picture is meant for the display as it is.
    request.finish.exposure = 0.0;
    request.finish.view = render::ViewTransform::standard;
    request.finish.dither = false;
    request.settings.unclipped = request.finish.display_format() == nullptr;
    return request;
}

std::string name_of_pov(const fs::path& output) {
    return output == "-" ? "standard output" : output.string();
}

void join_to(Diagnostics& diagnostics, const Diagnostics& more) {
    diagnostics.insert(diagnostics.end(), more.begin(), more.end());
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

void describe_pov(PovReport& outcome, const PovRequest& request, const camera::Picture& picture,
                  const render::Film& film, const bridge::PovrayProgram& program,
                  const bridge::PovraySummary& summary) {
    const std::size_t transparent = transparent_pixels(film);
    if (transparent > 0) {
        outcome.diagnostics.push_back(
            warning(fmt::format("no camera has a ray at {} of {} pixels; they are transparent",
                                transparent, film.window.size())));
    }
    join_to(outcome.diagnostics, app::warn_of_lost_alpha(film, request.finish));
    const bool interrupted = summary.interrupted;
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
    outcome.sentence =
        fmt::format("{}{}: {} x {} pixels through '{}', {}, {} rays; POV-Ray {} ran {} for {}\n",
                    interrupted ? "interrupted; the partial picture is " : "",
                    printable(name_of_pov(request.finish.output)), film.width, film.height,
                    picture.name(), counted(film.passes.front(), "pass", "passes"),
                    count_text(static_cast<double>(summary.camera_rays)), program.version,
                    summary.runs == 1 ? "once" : fmt::format("{} times", summary.runs),
                    duration_text(summary.povray_seconds));
}

void render_pov_picture(const PovOptions& options, PovReport& outcome) {
    const auto fails = [&outcome](Diagnostics found, Kind kind = Kind::input) {
        for (Diagnostic& one : found) {
            one.kind = one.kind == Kind::input ? kind : one.kind;
        }
        join_to(outcome.diagnostics, found);
        return has_errors(found);
    };
    PovRequest request = pov_request(options);
    lang::Workspace cameras;
    if (fails(check_output(request.finish.output))) {
        return;
    }
    Result<camera::Picture> picture = load_picture(options.camera, options.set, cameras);
    std::vector<fs::path> inputs = cameras.files();
    inputs.emplace_back(options.scene);
    inputs.push_back(camera_file(options.camera));
    if (fails(app::check_overwrites(request.finish.output, inputs)) || fails(picture.diagnostics)) {
        return;
    }
    *picture = picture->with_fit(request.size.fit);
    const auto [width, height] = request.size.resolve(picture->aspect(), picture->parts().size);
    Result<render::Film> film =
        render::make_film({.width = width, .height = height, .data_layers = false});
    const Result<bridge::PovrayProgram> program = bridge::find_povray();
    // POV-Ray writes images, whatever becomes of them.
    if (fails(film.diagnostics) || fails(program.diagnostics) ||
        fails(images::require(), Kind::environment)) {
        return;
    }
    RenderObserver observer(options.quiet || options.json);
    observer.observer().stoppable(true);
    const bridge::PovraySummary summary =
        bridge::render_with_povray(*program, options.scene, *picture, request.settings, *film,
                                   observer.observer().progress, observer.token());
    observer.clear();
    outcome.interrupted = summary.interrupted;
    if (fails(summary.diagnostics)) {
        return;
    }
    if (film->passes.front() == 0) {
        outcome.sentence = "interrupted before there was anything to save\n";
        return;
    }
    describe_pov(outcome, request, *picture, *film, *program, summary);
    if (!fails(app::write(request.finish, *film, observer.observer()))) {
        outcome.facts["output"] = request.finish.output.string();
    }
}

ExitCode pov(const PovOptions& options) {
    PovReport outcome;
    render_pov_picture(options, outcome);
    if (options.json) {
        outcome.facts["diagnostics"] = to_json(outcome.diagnostics);
        print_json(outcome.facts);
    } else {
        report(outcome.diagnostics);
        if (!options.quiet && !has_errors(outcome.diagnostics)) {
            if (options.output == "-") {
                print_aside(outcome.sentence);
            } else {
                print_result(outcome.sentence);
            }
        }
    }
    return exit_code_of(outcome.diagnostics, outcome.interrupted);
}

app::Options<PovOptions> povray_options() {
    using bridge::PovraySettings;
    constexpr double largest_time = 1e12;
    std::vector<app::OptionChoice> axes;
    for (const bridge::PovrayAxes& row : bridge::povray_axes()) {
        axes.push_back({std::string(row.name), std::string(row.meaning)});
    }
    return {{option({.name = "--samples",
                     .letter = "-s",
                     .placeholder = "COUNT",
                     .meaning = "rays per pixel, evenly spread over its square"},
                    app::count(1, 65'536), &PovOptions::settings, &PovraySettings::samples),
             option({.name = "--seed",
                     .placeholder = "NUMBER",
                     .meaning = "another number gives a lens other points"},
                    app::seed_value(), &PovOptions::settings, &PovraySettings::seed),
             option({.name = "--time",
                     .placeholder = "T",
                     .meaning = "t in the camera's formulas, and POV-Ray's clock"},
                    app::number(-largest_time, largest_time, "give a number", "s"),
                    &PovOptions::settings, &PovraySettings::time),
             option({.name = "--axes",
                     .placeholder = "AXES",
                     .meaning = "axes of the scene: " + app::described(axes, "; ")},
                    app::choice(axes), &PovOptions::settings, &PovraySettings::axes),
             app::words({.name = "OPTION",
                         .meaning = "options for POV-Ray itself, after --, such as +Q5 or "
                                    "Declare=Night=1"},
                        &PovOptions::settings, &PovraySettings::options),
             quiet_flag(&PovOptions::quiet),
             json_flag(&PovOptions::json, "print file name, counts and diagnostics as JSON")}};
}

}  // namespace

void add_pov_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, PovOptions& options) {
        app::Options<PovOptions> all{
            {option({.name = "SCENE.pov", .meaning = "scene file of POV-Ray", .required = true},
                    text(OptionType::file), &PovOptions::scene),
             option({.name = "--camera",
                     .letter = "-c",
                     .placeholder = "CAMERA",
                     .meaning = "camera: FILE, FILE:NAME, or the name of a built-in camera",
                     .required = true},
                    text(OptionType::camera), &PovOptions::camera),
             output_option(&PovOptions::output,
                           "picture file: .png, .jpg, .webp, .tif, or .exr for unclipped light; - "
                           "is standard output (default: the scene's name with .png, in this "
                           "folder)"),
             app::set_option(&PovOptions::set)}};
        all.add(&PovOptions::size, app::size_options("size of the picture in pixels"));
        all.add(&PovOptions::size, app::aspect_options());
        all.add(povray_options());
        command.add(std::move(all), options);
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
