// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/render_options.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "balcony/app.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/options/option_values.hpp"

namespace balcony::cli {

namespace {

std::optional<render::Color3f> read_background(const std::string& text, Diagnostics& diagnostics) {
    if (text == "auto" || text == "transparent") {
        return std::nullopt;
    }
    if (text == "black" || text == "white") {
        return render::Color3f(text == "white" ? 1.0F : 0.0F);
    }
    const auto color = color_of(text);
    if (!color || std::min({color->x, color->y, color->z}) < 0.0F) {
        refuse(
            diagnostics, "--background", text,
            "write auto, transparent, black, white, a grey level such as 0.2, or red,green,blue");
    }
    return color;
}

// More stops than between the smallest and the largest float would give 0 or infinity.
std::optional<double> read_exposure(const RenderOptions& options, Diagnostics& diagnostics) {
    if (options.exposure == "auto") {
        return std::nullopt;
    }
    constexpr double max_stops = 200.0;
    return read_number("--exposure", options.exposure, -max_stops, max_stops,
                       fmt::format("give auto, or stops from -{0} to {0}, such as -1.5", max_stops),
                       diagnostics);
}

void read_settings(const RenderOptions& options, app::Request& request, Diagnostics& diagnostics) {
    constexpr double any = std::numeric_limits<double>::max();
    constexpr float brightest = std::numeric_limits<float>::max();
    render::Settings& settings = request.settings;
    read_sampling(options.sampling, request, diagnostics);
    settings.threads = read_count("--threads", options.threads, 0, 1024, diagnostics);
    settings.time = read_number("--time", options.time, -any, any, "give a number", diagnostics);
    if (options.ambient != "auto") {
        settings.ambient =
            render::Color3f(read_number("--ambient", options.ambient, 0.0F, brightest,
                                        "give auto, or a number of at least 0", diagnostics));
    }
    read_integrator(options.integrator, settings, diagnostics);
    settings.background = read_background(options.background, diagnostics);
    settings.light.visible = options.background == "auto";
}

}  // namespace

void add_scene_options(CLI::App& command, RenderOptions& options) {
    command
        .add_option("--add", options.add,
                    "another scene file, which joins each scene: the arrows of a camera by "
                    "balcony draw, say; may be repeated")
        ->type_name("SCENE")
        ->allow_extra_args(false)
        ->take_all();
    command
        .add_option(
            "-c,--camera", options.camera,
            "camera file and the NAME of a camera or picture in it (default: the last), or a "
            "built-in camera; scene:NAME is a camera of the scene (default: its first, or one "
            "that shows the scene well)")
        ->type_name("FILE[:NAME]");
    add_set_option(command, options.set);
    add_fit_options(command, options.fit);
}

void add_picture_options(CLI::App& command, RenderOptions& options) {
    add_size_options(command, options.size,
                     "size in pixels (default: that of the picture, or about a million pixels with "
                     "its aspect ratio)");
    add_aspect_option(command, options.size);
    add_crop_options(command, options.crop);
    add_sampling_options(command, options.sampling);
    add_integrator_options(command, options.integrator);
    add_light_options(command, options.light);
    command
        .add_option(
            "--exposure", options.exposure,
            "exposure in stops (PNG); auto changes pictures that would be nearly black or white")
        ->type_name("STOPS")
        ->capture_default_str();
    std::vector<std::string> views;
    for (const std::string& name : render::view_transforms().all()) {
        views.push_back(
            fmt::format("{} ({})", name,
                        render::view_transforms()[*render::view_transforms().find(name)].meaning));
    }
    command
        .add_option(
            "--view-transform", options.view,
            fmt::format("from light to display colours (PNG): {}", fmt::join(views, " or ")))
        ->type_name("NAME")
        ->capture_default_str();
    command
        .add_option(
            "--ambient", options.ambient,
            "light from all directions: with path an environment of this radiance, with direct "
            "without shadows; auto follows the scene's lights with direct")
        ->type_name("RADIANCE")
        ->capture_default_str();
    command
        .add_option("--background", options.background,
                    "transparent, black, white, a grey level, or red,green,blue (linear, from 0 to "
                    "1), as the display shows it; auto shows the environment, if there is one")
        ->type_name("COLOUR")
        ->capture_default_str();
    add_film_options(command, options.film);
    add_texture_options(command, options.textures);
}

void add_run_options(CLI::App& command, RenderOptions& options) {
    command.add_option("-j,--threads", options.threads, "number of threads; 0 uses all processors")
        ->type_name("COUNT")
        ->capture_default_str();
    add_quiet_option(command, options.quiet);
    command.add_flag("--json", options.json, "print facts and diagnostics as JSON");
}

app::Request read_request(const RenderOptions& options, Diagnostics& diagnostics) {
    app::Request request;
    request.added = options.add;
    request.camera = options.camera;
    request.set = options.set;
    request.fit = options.fit.fit;
    request.fit_to = options.fit.object;
    read_settings(options, request, diagnostics);
    request.light = read_light(options.light, diagnostics);
    request.shutter = read_shutter(options.shutter, diagnostics);
    request.exposure = read_exposure(options, diagnostics);
    check_name("--view-transform", options.view, render::view_transforms().all(), diagnostics);
    if (options.command->count("--view-transform") > 0) {
        request.view = render::view_transforms().find(options.view);
    }
    request.size = read_size(options.size, diagnostics);
    request.layers = read_layers(options.film, diagnostics);
    request.crop = read_crop(options.crop, diagnostics);
    request.job = read_job(options.job, diagnostics);
    request.texture_memory = read_texture_memory(options.textures, diagnostics);
    request.denoise = options.film.denoise;
    request.denoiser = read_denoiser(options.film, diagnostics);
    request.dither = !options.film.no_dither;
    request.stereo = read_stereo(options.stereo, diagnostics);
    const Diagnostics found = app::check_request(request);
    diagnostics.insert(diagnostics.end(), found.begin(), found.end());
    return request;
}

}  // namespace balcony::cli
