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

#include "balcony/app.hpp"
#include "balcony/images.hpp"
#include "balcony/inputs.hpp"
#include "balcony/names.hpp"
#include "balcony/povray.hpp"
#include "base/memory.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/options/picture_output.hpp"
#include "cli/report/render_observer.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

struct PovOptions {
    std::string scene;
    std::string camera;
    std::string output;
    std::vector<std::string> set;
    SizeRequest size;
    bridge::PovraySettings settings;
    Manner manner;
};

struct PovRequest {
    bridge::PovraySettings settings;
    SizeRequest size;
    app::Finish finish;
};

PovRequest pov_request(const PovOptions& options) {
    const fs::path file = options.output.empty()
                              ? fs::path(fs::path(options.scene).stem().string() + ".png")
                              : fs::path(options.output);
    PovRequest request{options.settings, options.size, {.output = file}};
    // POV-Ray's picture is meant for the display as it is.
    request.finish.view = render::ViewTransform::standard;
    request.finish.dither = false;
    request.settings.unclipped = request.finish.display_format() == nullptr;
    return request;
}

std::string name_of_pov(const fs::path& output) {
    return output == "-" ? "standard output" : output.string();
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

void describe_pov(Answer& answer, const PovRequest& request, const camera::Picture& picture,
                  const render::Film& film, const bridge::PovrayProgram& program,
                  const bridge::PovraySummary& summary) {
    const std::size_t transparent = transparent_pixels(film);
    if (transparent > 0) {
        answer.diagnostics.push_back(
            warning(fmt::format("no camera has a ray at {} of {} pixels; they are transparent",
                                transparent, film.window.size())));
    }
    answer.add(app::warn_of_lost_alpha(film, request.finish));
    answer.facts = {{"output", nullptr},
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
                    {"interrupted", summary.interrupted}};
    answer.text = fmt::format(
        "{}{}: {} x {} pixels through '{}', {}, {} rays; POV-Ray {} ran {} for {}\n",
        summary.interrupted ? "interrupted; the partial picture is " : "",
        printable(name_of_pov(request.finish.output)), film.width, film.height, picture.name(),
        counted(film.passes.front(), "pass"), count_text(static_cast<double>(summary.camera_rays)),
        program.version, summary.runs == 1 ? "once" : fmt::format("{} times", summary.runs),
        duration_text(summary.povray_seconds));
}

void render_pov_picture(const PovOptions& options, Answer& answer) {
    PovRequest request = pov_request(options);
    if (!answer.add(check_output(request.finish.output))) {
        return;
    }
    lang::Workspace cameras;
    Result<camera::Picture> picture = load_picture(options.camera, options.set, cameras);
    std::vector<fs::path> inputs = cameras.files();
    inputs.emplace_back(options.scene);
    inputs.push_back(app::camera_file(options.camera));
    if (!answer.add(app::check_overwrites(request.finish.output, inputs)) ||
        !answer.add(picture.diagnostics)) {
        return;
    }
    *picture = picture->with_fit(request.size.fit);
    const auto [width, height] = request.size.resolve(picture->aspect(), picture->parts().size);
    Result<render::Film> film =
        render::make_film({.width = width, .height = height, .data_layers = false});
    const Result<bridge::PovrayProgram> program = bridge::find_povray();
    // POV-Ray writes images, whatever becomes of them.
    if (!answer.add(film.diagnostics) || !answer.add(program.diagnostics) ||
        !answer.add(images::require())) {
        return;
    }
    RenderObserver observer(options.manner);
    const bridge::PovraySummary summary =
        bridge::render_with_povray(*program, options.scene, *picture, request.settings, *film,
                                   observer.observer().progress, observer.token());
    observer.clear();
    answer.interrupted = summary.interrupted;
    if (!answer.add(summary.diagnostics)) {
        return;
    }
    if (film->passes.front() == 0) {
        answer.text = "interrupted before there was anything to save\n";
        return;
    }
    describe_pov(answer, request, *picture, *film, *program, summary);
    if (answer.add(app::write(request.finish, *film, observer.observer()))) {
        answer.facts["output"] = request.finish.output.string();
    } else {
        answer.text.clear();
    }
}

ExitCode pov(const PovOptions& options) {
    Answer answer;
    answer.print = options.output == "-" ? print_aside : print_result;
    render_pov_picture(options, answer);
    return give(answer, options.manner);
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
                        &PovOptions::settings, &PovraySettings::options)}};
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
        all.add(
            manner_options(&PovOptions::manner, "print file name, counts and diagnostics as JSON"));
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
