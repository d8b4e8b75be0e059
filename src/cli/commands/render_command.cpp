// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "balcony/probe.hpp"
#include "balcony/render.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/options/default_camera.hpp"
#include "cli/options/render_options.hpp"
#include "cli/options/scene_argument.hpp"
#include "cli/report/json.hpp"
#include "cli/report/miss_text.hpp"
#include "cli/report/progress_display.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

/// The report of a render, as text or JSON.
struct Outcome {
    ExitCode code = ExitCode::done;
    Diagnostics diagnostics;
    nlohmann::json facts = nlohmann::json::object();
    std::string sentence;
};

void add(Outcome& outcome, const Diagnostics& diagnostics) {
    outcome.diagnostics.insert(outcome.diagnostics.end(), diagnostics.begin(), diagnostics.end());
}

Outcome fail(Outcome outcome, ExitCode code, const Diagnostics& diagnostics = {}) {
    add(outcome, diagnostics);
    outcome.code = code;
    return outcome;
}

/// The output file: given by the user, or in this folder and named after the scene.
fs::path output_of(const RenderOptions& options) {
    if (options.output) {
        return *options.output;
    }
    const std::string stem = fs::path(options.scene).stem().string();
    return (stem.empty() || stem.front() == '.' ? "picture" : stem) + ".png";
}

/// Rejects an output file that cannot be written, before rendering.
ExitCode check_output(const fs::path& file, Diagnostics& diagnostics) {
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) {
        diagnostics.push_back(
            error(fmt::format("'{}' is a folder", file.string()), {},
                  fmt::format("name a file in it: {}", (file / "picture.png").string())));
        return ExitCode::wrong_usage;
    }
    const Diagnostics found = render::check_output(file);
    diagnostics.insert(diagnostics.end(), found.begin(), found.end());
    const std::string ending = ending_of(file);
    return !has_errors(found)                     ? ExitCode::done
           : ending != ".png" && ending != ".exr" ? ExitCode::wrong_usage
                                                  : ExitCode::environment;
}

/// Rejects an output file that is also an input, even under another name or through a link.
Diagnostics check_inputs_kept(const RenderOptions& options, const scene::Scene& scene,
                              const fs::path& output) {
    std::vector<fs::path> inputs{options.scene, camera_file(options.camera)};
    for (const scene::Texture& texture : scene.textures) {
        inputs.push_back(texture.file);
    }
    for (const fs::path& input : inputs) {
        std::error_code failed;
        if (!input.empty() && fs::equivalent(input, output, failed) && !failed) {
            return {error(
                fmt::format("'{}' is part of the scene and would be overwritten", output.string()),
                {}, "name another picture with --output")};
        }
    }
    return {};
}

/// Reports where a layer has no ray.
void describe_gaps(Outcome& outcome, const render::Film& film, const render::Summary& summary) {
    const bool single = summary.layers.size() == 1;
    const std::string_view shown = film.background ? "show the background" : "are transparent";
    for (const render::Summary::Layer& layer : summary.layers) {
        const std::string what =
            fmt::format("{} '{}'", single ? "camera" : "layer", printable(layer.name));
        if (layer.invalid_rays == 0) {
            continue;
        }
        if (layer.invalid_rays == layer.camera_rays) {
            outcome.diagnostics.push_back(
                warning(fmt::format("{} has no ray anywhere; {}", what,
                                    single ? "the picture is empty" : "it is invisible")));
            continue;
        }
        const std::string pixels = single ? fmt::format(" ({} of {} pixel centres)",
                                                        summary.invalid_pixels, film.window.size())
                                          : "";
        outcome.diagnostics.push_back(
            warning(fmt::format("{} has no ray at {} of {} picture points{}; they {}", what,
                                layer.invalid_rays, layer.camera_rays, pixels, shown)));
    }
}

/// Warns of layers whose rays meet nothing, with the reason.
void describe_misses(Outcome& outcome, const scene::Scene& scene, const camera::Picture& picture,
                     const render::Settings& settings, const render::Film& film,
                     const render::Summary& summary) {
    for (const camera::ShownCamera& shown : shown_cameras(picture)) {
        for (const camera::ShownCamera::LayerUse& use : shown.uses) {
            const render::Summary::Layer& layer = summary.layers[use.index];
            if (layer.hits > 0 || layer.camera_rays == layer.invalid_rays) {
                continue;
            }
            const Result<render::Miss> miss = render::explain_miss(
                scene, shown.camera,
                {.width = film.width, .height = film.height, .time = settings.time});
            const MissText text = miss ? miss_text(*miss, shown.camera) : MissText{};
            outcome.diagnostics.push_back(warning(
                fmt::format("no ray of {} '{}' meets anything{}{}",
                            summary.layers.size() == 1 ? "camera" : "layer", printable(layer.name),
                            text.reason.empty() ? "" : ": ", text.reason),
                {}, text.remedy));
        }
    }
}

nlohmann::json layers_json(const render::Summary& summary) {
    nlohmann::json layers = nlohmann::json::array();
    for (const render::Summary::Layer& layer : summary.layers) {
        layers.push_back({{"name", layer.name},
                          {"rays", layer.camera_rays},
                          {"invalid_rays", layer.invalid_rays},
                          {"hits", layer.hits}});
    }
    return layers;
}

// One line per layer of a picture with several layers.
std::string layers_text(const render::Summary& summary) {
    std::string text;
    for (const render::Summary::Layer& layer : summary.layers) {
        text += fmt::format("  layer {:<20} {} rays\n", printable(layer.name),
                            count_text(static_cast<double>(layer.camera_rays)));
    }
    return summary.layers.size() > 1 ? text : "";
}

void describe(Outcome& outcome, const fs::path& output, const camera::Picture& picture,
              const render::Film& film, const render::Summary& summary) {
    describe_gaps(outcome, film, summary);
    if (summary.repaired > 0) {
        outcome.diagnostics.push_back(warning(fmt::format(
            "{} samples had no finite colour and were replaced by black", summary.repaired)));
    }
    outcome.facts = {{"output", nullptr},
                     {"camera", picture.name()},
                     {"layers", layers_json(summary)},
                     {"width", film.width},
                     {"height", film.height},
                     {"passes", summary.passes},
                     {"rays", summary.camera_rays},
                     {"invalid_rays", summary.invalid_rays},
                     {"invalid_pixels", summary.invalid_pixels},
                     {"repaired", summary.repaired},
                     {"seconds", summary.seconds},
                     {"compile_seconds", summary.compile_seconds},
                     {"camera_share", summary.camera_share},
                     {"ambient", summary.ambient.x},
                     {"interrupted", summary.interrupted}};
    outcome.sentence = fmt::format(
        "{}{}: {} x {} pixels through '{}', {}, {} rays in {}\n",
        summary.interrupted ? "interrupted; the partial picture is " : "",
        printable(output.string()), film.width, film.height, picture.name(),
        counted(summary.passes, "pass", "passes"),
        count_text(static_cast<double>(summary.camera_rays)), duration_text(summary.seconds));
    outcome.sentence += layers_text(summary);
}

bool has_samples(const render::Film& film) {
    return std::any_of(film.passes.begin(), film.passes.end(),
                       [](std::uint32_t count) { return count > 0; });
}

/// How light becomes display colours.
struct Tones {
    std::optional<double> exposure;  ///< Chosen automatically if empty.
    render::ViewTransform view;
};

/// Renders and writes. The first signal stops the rendering, but not the writing.
Outcome make_picture(Outcome outcome, const RenderOptions& options, const scene::Scene& scene,
                     const render::Renderer& renderer, const camera::Picture& picture,
                     const render::Settings& settings, render::Film film, const fs::path& output,
                     const Tones& tones) {
    const Job job;
    Result<render::Summary> summary;
    {
        ProgressDisplay display(options.quiet || options.json);
        summary = render::render(
            renderer, picture, settings, film,
            [&](const render::Progress& progress) { display.show(progress); }, job.token());
    }
    add(outcome, summary.diagnostics);
    if (!summary) {
        return fail(std::move(outcome), ExitCode::bad_input);
    }
    describe(outcome, output, picture, film, *summary);
    if (!summary->interrupted) {
        describe_misses(outcome, scene, picture, settings, film, *summary);
    }
    if (!has_samples(film)) {
        outcome.sentence = "interrupted before there was anything to save\n";
        return fail(std::move(outcome), ExitCode::interrupted);
    }
    const double exposure = tones.exposure                ? *tones.exposure
                            : ending_of(output) == ".png" ? render::automatic_exposure(film)
                                                          : 0.0;
    outcome.facts["exposure"] = exposure;
    if (!tones.exposure && exposure != 0.0) {
        outcome.sentence += fmt::format(
            "  exposure {:+} stops, ambient light {:.3g}; --exposure and --ambient set them\n",
            exposure, summary->ambient.x);
    }
    const Diagnostics written =
        render::write(film, output, {.exposure = exposure, .view = tones.view});
    if (has_errors(written)) {
        return fail(std::move(outcome), ExitCode::environment, written);
    }
    outcome.facts["output"] = output.string();
    outcome.code = summary->interrupted ? ExitCode::interrupted : ExitCode::done;
    return outcome;
}

Outcome render_picture(const RenderOptions& options) {
    Outcome outcome;
    const render::Settings settings = read_settings(options, outcome.diagnostics);
    const Tones tones{read_exposure(options, outcome.diagnostics),
                      read_view(options, outcome.diagnostics)};
    const PictureSize size = read_size(options.size, outcome.diagnostics);
    if (options.camera.empty() && !options.set.empty()) {
        outcome.diagnostics.push_back(
            error("--set needs a camera whose parameter it sets", {}, "add --camera FILE"));
    }
    if (has_errors(outcome.diagnostics)) {
        return fail(std::move(outcome), ExitCode::wrong_usage);
    }
    const fs::path output = output_of(options);
    if (const ExitCode code = check_output(output, outcome.diagnostics); code != ExitCode::done) {
        return fail(std::move(outcome), code);
    }

    // A camera loads fast, so its mistakes are reported before a large scene is read.
    Result<camera::Picture> picture;
    const bool of_file = !options.camera.empty() && !is_of_scene(options.camera);
    if (of_file) {
        picture = load_picture(options.camera, options.set);
        add(outcome, picture.diagnostics);
    }
    if (has_errors(outcome.diagnostics)) {
        return fail(std::move(outcome), ExitCode::bad_input);
    }
    auto scene = load_scene(options.scene);
    add(outcome, scene.diagnostics);
    if (!scene) {
        return fail(std::move(outcome), ExitCode::bad_input);
    }
    if (const Diagnostics diagnostics = check_inputs_kept(options, *scene, output);
        has_errors(diagnostics)) {
        return fail(std::move(outcome), ExitCode::wrong_usage, diagnostics);
    }
    const auto shared = std::make_shared<const scene::Scene>(std::move(*scene));
    if (!of_file) {
        picture = options.camera.empty() ? default_picture(*shared)
                                         : load_picture(options.camera, options.set, *shared);
        add(outcome, picture.diagnostics);
    }
    const auto renderer = render::Renderer::make(shared);
    add(outcome, renderer.diagnostics);
    if (!picture || !renderer) {
        return fail(std::move(outcome), ExitCode::bad_input);
    }
    const auto [width, height] = size.resolve(picture->parts().aspect, picture->parts().size);
    Result<render::Film> film = render::make_film(
        {.width = width, .height = height, .data_layers = ending_of(output) == ".exr"});
    if (!film) {
        return fail(std::move(outcome), ExitCode::bad_input, film.diagnostics);
    }
    return make_picture(std::move(outcome), options, *shared, *renderer, *picture, settings,
                        std::move(*film), output, tones);
}

ExitCode render_command(const RenderOptions& options) {
    Outcome outcome = render_picture(options);
    if (options.json) {
        outcome.facts["diagnostics"] = to_json(outcome.diagnostics);
        print_json(outcome.facts);
        return outcome.code;
    }
    report(outcome.diagnostics);
    if (!options.quiet && !has_errors(outcome.diagnostics)) {
        print_result(outcome.sentence);
    }
    return outcome.code;
}

void add_picture_options(CLI::App& command, RenderOptions& options) {
    command
        .add_option("--size", options.size,
                    "size in pixels (default: that of the picture, or about a million pixels with "
                    "its aspect ratio)")
        ->type_name("WIDTH[xHEIGHT]");
    command.add_option("-s,--samples", options.samples, "rays per pixel")
        ->type_name("COUNT")
        ->capture_default_str();
    std::vector<std::string> integrators;
    for (const render::IntegratorInfo& row : render::integrators()) {
        integrators.push_back(fmt::format("{} ({})", row.name, row.meaning));
    }
    command
        .add_option("--integrator", options.integrator,
                    fmt::format("{}", fmt::join(integrators, " or ")))
        ->type_name("NAME")
        ->capture_default_str();
    command
        .add_option(
            "--exposure", options.exposure,
            "exposure in stops (PNG); auto changes pictures that would be nearly black or white")
        ->type_name("STOPS")
        ->capture_default_str();
    std::vector<std::string> views;
    for (const std::string& name : render::view_transform_names()) {
        views.push_back(
            fmt::format("{} ({})", name, meaning_of(*render::find_view_transform(name))));
    }
    command
        .add_option(
            "--view-transform", options.view,
            fmt::format("from light to display colours (PNG): {}", fmt::join(views, " or ")))
        ->type_name("NAME")
        ->capture_default_str();
    command
        .add_option("--ambient", options.ambient,
                    "light from all directions, without shadows; auto follows the scene's lights")
        ->type_name("RADIANCE")
        ->capture_default_str();
    command
        .add_option("--background", options.background,
                    "transparent, black, white, a grey level, or red,green,blue (linear, from 0 to "
                    "1), as the display shows it")
        ->type_name("COLOUR")
        ->capture_default_str();
}

}  // namespace

void add_render_command(CLI::App& app, ExitCode& code) {
    auto* command = app.add_subcommand("render", "renders a scene through a camera");
    command->group("Commands");
    const auto options = std::make_shared<RenderOptions>();
    command->add_option("SCENE", options->scene, scene_files_text())->required();
    command
        ->add_option(
            "-c,--camera", options->camera,
            "camera file and the NAME of a camera or picture in it (default: the last), or a "
            "built-in camera; scene:NAME is a camera of the scene (default: its first, or one "
            "that shows the scene well)")
        ->type_name("FILE[:NAME]");
    add_set_option(*command, options->set);
    command->add_option("--time", options->time, "value of t in the camera's formulas")
        ->type_name("T")
        ->capture_default_str();
    command
        ->add_option_function<std::string>(
            "-o,--output", [options](const std::string& file) { options->output = file; },
            "output file: .png, or .exr with all layers (default: SCENE.png in this folder)")
        ->type_name("FILE");
    add_picture_options(*command, *options);
    command
        ->add_option("-j,--threads", options->threads, "number of threads; 0 uses all processors")
        ->type_name("COUNT")
        ->capture_default_str();
    command->add_flag("-q,--quiet", options->quiet, "print only warnings and errors");
    command->add_flag("--json", options->json, "print facts and diagnostics as JSON");
    command->footer(
        "Examples:\n"
        "  balcony render room.glb -o room.png\n"
        "  balcony render room.glb --camera superelliptic --set gamma=1/2 -o walls.png\n"
        "  balcony render room.glb --camera my.cam:closeup --size 1920x1080 -s 64\n"
        "  balcony render filmed.gltf --camera scene:Front\n"
        "\n"
        "Ctrl-C saves the partial picture; a second Ctrl-C ends at once.");
    command->callback([options, &code] { code = render_command(*options); });
}

}  // namespace balcony::cli
