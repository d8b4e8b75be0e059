// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/lang.hpp"
#include "balcony/render.hpp"
#include "cli/command.hpp"
#include "cli/default_camera.hpp"
#include "cli/interruption.hpp"
#include "cli/json.hpp"
#include "cli/progress_display.hpp"
#include "cli/report.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

struct RenderOptions {
    std::string scene;
    std::string camera;
    std::string output;
    std::string size;
    std::vector<std::string> set;
    std::string integrator = "direct";
    std::string background = "transparent";
    std::size_t samples = 16;
    std::size_t threads = 0;
    double time = 0.0;
    double exposure = 0.0;
    float ambient = 0.1F;
    bool quiet = false;
    bool json = false;
};

/// What the render says of itself, to people or to programs.
struct Outcome {
    ExitCode code = ExitCode::done;
    Diagnostics said;
    nlohmann::json facts = nlohmann::json::object();
    std::string sentence;
};

void add(Outcome& outcome, const Diagnostics& said) {
    outcome.said.insert(outcome.said.end(), said.begin(), said.end());
}

/// FILE, FILE:NAME or the name of a standard camera.
std::pair<fs::path, std::string> split_camera(const std::string& text) {
    const auto colon = text.rfind(':');
    if (colon == std::string::npos || fs::exists(text)) {
        return {text, ""};
    }
    return {text.substr(0, colon), text.substr(colon + 1)};
}

Result<camera::Camera> load_camera(const RenderOptions& options, const scene::Scene& scene) {
    std::vector<lang::Override> overrides;
    for (const std::string& text : options.set) {
        const auto equals = text.find('=');
        if (equals == std::string::npos || equals == 0) {
            return error(fmt::format("--set {} sets nothing", text), {},
                         "write --set name=value, such as --set gamma=1/2");
        }
        overrides.push_back({text.substr(0, equals), text.substr(equals + 1)});
    }
    if (options.camera.empty()) {
        if (!overrides.empty()) {
            return error("--set needs a camera to set something of", {}, "add --camera FILE");
        }
        return default_camera(scene);
    }
    const auto [file, name] = split_camera(options.camera);
    return lang::load_camera(file, name, overrides);
}

/// WIDTHxHEIGHT, or WIDTH alone, or nothing: the camera's own proportion, about a million pixels.
std::optional<std::pair<std::size_t, std::size_t>> picture_size(const std::string& text,
                                                                double aspect) {
    constexpr double default_pixels = 1280.0 * 720.0;
    constexpr unsigned long largest = 1'000'000;
    const auto height_of = [aspect](double width) {
        return static_cast<std::size_t>(std::max(1.0, std::round(width / aspect)));
    };
    if (text.empty()) {
        const double width = std::max(1.0, std::round(std::sqrt(default_pixels * aspect)));
        return std::pair{static_cast<std::size_t>(width), height_of(width)};
    }
    const auto number = [](const std::string& digits) -> std::optional<std::size_t> {
        if (digits.empty() || digits.size() > 7 ||
            digits.find_first_not_of("0123456789") != std::string::npos) {
            return std::nullopt;
        }
        const unsigned long value = std::stoul(digits);
        return value >= 1 && value <= largest ? std::optional<std::size_t>(value) : std::nullopt;
    };
    const auto cross = text.find_first_of("xX");
    const auto width = number(text.substr(0, cross));
    if (cross == std::string::npos) {
        return width ? std::optional(std::pair{*width, height_of(static_cast<double>(*width))})
                     : std::nullopt;
    }
    const auto height = number(text.substr(cross + 1));
    return width && height ? std::optional(std::pair{*width, *height}) : std::nullopt;
}

/// "transparent", "black", "white" or a linear grey level or r,g,b.
std::optional<std::optional<render::Color3f>> background_of(const std::string& text) {
    if (text == "transparent") {
        return std::optional<render::Color3f>{};
    }
    if (text == "black" || text == "white") {
        return render::Color3f(text == "white" ? 1.0F : 0.0F);
    }
    render::Color3f color;
    char end = 0;
    if (std::sscanf(text.c_str(), "%f,%f,%f%c", &color.x, &color.y, &color.z, &end) == 3) {
        return color;
    }
    if (std::sscanf(text.c_str(), "%f%c", &color.x, &end) == 1) {
        return render::Color3f(color.x);
    }
    return std::nullopt;
}

Outcome fail(Outcome outcome, ExitCode code, const Diagnostics& said) {
    add(outcome, said);
    outcome.code = code;
    return outcome;
}

void describe(Outcome& outcome, const RenderOptions& options, const camera::Camera& camera,
              const render::Settings& settings, const render::Summary& summary) {
    const auto rays = static_cast<double>(summary.camera_rays);
    if (summary.invalid_rays > 0) {
        outcome.said.push_back(warning(
            fmt::format("camera '{}' has no ray at {} of {} pixels; they are transparent",
                        camera.name(), summary.invalid_pixels, settings.width * settings.height)));
    }
    if (summary.repaired > 0) {
        outcome.said.push_back(warning(
            fmt::format("{} samples had no finite colour and count as black", summary.repaired)));
    }
    outcome.facts = {{"output", options.output},
                     {"camera", camera.name()},
                     {"width", settings.width},
                     {"height", settings.height},
                     {"passes", summary.passes},
                     {"rays", summary.camera_rays},
                     {"invalid_rays", summary.invalid_rays},
                     {"invalid_pixels", summary.invalid_pixels},
                     {"repaired", summary.repaired},
                     {"seconds", summary.seconds},
                     {"compile_seconds", summary.compile_seconds},
                     {"camera_share", summary.camera_share},
                     {"interrupted", summary.interrupted}};
    outcome.sentence =
        fmt::format("{}{}: {} x {} pixels through '{}', {} passes, {} rays in {}\n",
                    summary.interrupted ? "interrupted; what was done is in " : "", options.output,
                    settings.width, settings.height, camera.name(), summary.passes,
                    count_text(rays), duration_text(summary.seconds));
}

Outcome render_picture(RenderOptions options) {
    Outcome outcome;
    const auto integrator = render::find_integrator(options.integrator);
    const auto background = background_of(options.background);
    if (!background) {
        return fail(outcome, ExitCode::wrong_usage,
                    {error(fmt::format("'{}' is no background", options.background), {},
                           "write transparent, black, white, a grey level such as 0.2, or r,g,b")});
    }
    if (options.output.empty()) {
        options.output = fs::path(options.scene).stem().string() + ".png";
    }
    if (const Diagnostics said = render::check_output(options.output); has_errors(said)) {
        return fail(outcome, ExitCode::environment, said);
    }

    auto scene = scene::load(options.scene);
    add(outcome, scene.diagnostics);
    if (!scene) {
        return fail(outcome, ExitCode::bad_input, {});
    }
    const auto shared = std::make_shared<const scene::Scene>(std::move(*scene));
    const auto camera = load_camera(options, *shared);
    add(outcome, camera.diagnostics);
    if (!camera) {
        return fail(outcome, ExitCode::bad_input, {});
    }
    const auto size = picture_size(options.size, camera->parts().aspect);
    if (!size) {
        return fail(outcome, ExitCode::wrong_usage,
                    {error(fmt::format("'{}' is no picture size", options.size), {},
                           "write --size 1920x1080, or --size 1920 for the camera's proportion")});
    }

    render::Settings settings;
    settings.width = size->first;
    settings.height = size->second;
    settings.samples = options.samples;
    settings.integrator = *integrator;
    settings.threads = options.threads;
    settings.time = options.time;
    settings.ambient = render::Color3f(options.ambient);
    settings.background = *background;
    settings.data_layers = options.output.ends_with(".exr");

    const auto renderer = render::Renderer::make(shared);
    add(outcome, renderer.diagnostics);
    if (!renderer) {
        return fail(outcome, ExitCode::bad_input, {});
    }
    Result<render::Picture> picture;
    {
        ProgressDisplay display(options.quiet || options.json);
        picture = renderer->render(
            *camera, settings, [&](const render::Progress& progress) { display.show(progress); },
            Interruption::begin_job());
        Interruption::end_job();
    }
    add(outcome, picture.diagnostics);
    if (!picture) {
        return fail(outcome, ExitCode::bad_input, {});
    }
    describe(outcome, options, *camera, settings, picture->summary);
    const Diagnostics written =
        render::write(picture->film, options.output, {.exposure = options.exposure});
    if (has_errors(written)) {
        return fail(outcome, ExitCode::environment, written);
    }
    outcome.code = picture->summary.interrupted ? ExitCode::interrupted : ExitCode::done;
    return outcome;
}

ExitCode render_command(const RenderOptions& options) {
    Outcome outcome = render_picture(options);
    if (options.json) {
        outcome.facts["diagnostics"] = to_json(outcome.said);
        fmt::print("{}\n", outcome.facts.dump(2));
        return outcome.code;
    }
    report(outcome.said);
    if (!options.quiet && !has_errors(outcome.said)) {
        fmt::print("{}", outcome.sentence);
    }
    return outcome.code;
}

}  // namespace

void add_render_command(CLI::App& app, ExitCode& code) {
    auto* command = app.add_subcommand("render", "renders a scene through a camera");
    const auto options = std::make_shared<RenderOptions>();
    command->add_option("SCENE", options->scene, "a scene file (.glb, .gltf, .obj)")->required();
    command->add_option("-c,--camera", options->camera,
                        "FILE.cam, FILE.cam:NAME (default: its last camera), or the name of a "
                        "camera that comes along; without it a pinhole that sees all");
    command->add_option("-o,--output", options->output,
                        "the picture: .png, or .exr with all layers (default: SCENE.png here)");
    command->add_option("--size", options->size,
                        "WIDTHxHEIGHT in pixels, or WIDTH (default: the camera's proportion)");
    command->add_option("-s,--samples", options->samples, "rays a pixel")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    command->add_option("--set", options->set, "a camera's parameter: name=expression")
        ->allow_extra_args(false);
    command->add_option("--time", options->time, "the t of the camera's formulas");
    command
        ->add_option("--integrator", options->integrator,
                     "direct (lights, shadows, mirrors) or preview (lit from the eye)")
        ->check(CLI::IsMember({"direct", "preview"}))
        ->capture_default_str();
    command->add_option("--exposure", options->exposure, "brighter by so many stops (PNG)");
    command->add_option("--ambient", options->ambient, "light from everywhere")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    command
        ->add_option("--background", options->background,
                     "transparent, black, white, a grey level or r,g,b")
        ->capture_default_str();
    command->add_option("-j,--threads", options->threads, "0: all there are")
        ->check(CLI::Range(0, 1024));
    command->add_flag("-q,--quiet", options->quiet, "only warnings and errors");
    command->add_flag("--json", options->json, "for programs: facts and diagnostics");
    command->footer(
        "Examples:\n"
        "  balcony render room.glb -o room.png\n"
        "  balcony render room.glb --camera superelliptic --set gamma=1/2 -o walls.png\n"
        "  balcony render room.glb --camera my.cam:closeup --size 1920x1080 -s 64\n"
        "Ctrl-C saves what is there; a second one ends at once.");
    command->callback([options, &code] { code = render_command(*options); });
}

}  // namespace balcony::cli
