// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <stop_token>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/bands.hpp"
#include "balcony/render.hpp"
#include "cli/banded_picture.hpp"
#include "cli/commands/command.hpp"
#include "cli/denoised_picture.hpp"
#include "cli/file_watch.hpp"
#include "cli/frame_pictures.hpp"
#include "cli/interruption.hpp"
#include "cli/loaded_picture.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/options/common_options.hpp"
#include "cli/options/default_camera.hpp"
#include "cli/options/picture_output.hpp"
#include "cli/options/render_options.hpp"
#include "cli/options/scene_argument.hpp"
#include "cli/picture_run.hpp"
#include "cli/render_request.hpp"
#include "cli/report/json.hpp"
#include "cli/report/render_report.hpp"
#include "cli/report/report.hpp"
#include "cli/report/usage.hpp"
#include "cli/shard_picture.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

bool has_samples(const render::Film& film) {
    return std::any_of(film.passes.begin(), film.passes.end(),
                       [](std::uint32_t count) { return count > 0; });
}

/// Tells whether the picture that is being rendered is of no use any more.
using OutdatedTest = std::function<bool()>;

/// Renders and writes. The first signal stops the rendering, but not the writing.
RenderReport make_picture(RenderReport outcome, const RenderOptions& options,
                          const Request& request, const Loaded& loaded,
                          const camera::Picture& picture, render::Film film,
                          const PictureOutput& output, const OutdatedTest& is_outdated) {
    const Job interruption;
    std::stop_source stop;
    const std::stop_callback on_signal(interruption.token(), [&stop] { stop.request_stop(); });
    Result<render::Job> job = render::Job::make(*loaded.renderer, picture, request.settings, film);
    add(outcome, job.diagnostics);
    if (!job) {
        return failed(std::move(outcome), ExitCode::bad_input);
    }
    PictureRun run(options, request, loaded.files(), output, film);
    if (const Diagnostics found = run.resume(); has_errors(found)) {
        return failed(std::move(outcome), ExitCode::bad_input, found);
    }
    const Result<render::Summary> summary = run.run(
        *job,
        [&](const render::Progress&) {
            if (is_outdated && is_outdated()) {
                outcome.outdated = true;
                stop.request_stop();
            }
        },
        stop.get_token());
    add(outcome, summary.diagnostics);
    if (!summary) {
        return failed(std::move(outcome), ExitCode::bad_input);
    }
    if (outcome.outdated && !interruption.token().stop_requested()) {
        return outcome;
    }
    if (summary->interrupted && !stop.stop_requested()) {
        return failed(std::move(outcome), ExitCode::environment,
                      {error("a texture cannot be read any more, so the render ends", {},
                             fmt::format("restore it and continue with --resume from '{}'",
                                         run.checkpoint().file().string()))});
    }
    if (request.job.shard) {
        return keep_shard(std::move(outcome), request, output, run, *summary);
    }
    describe(outcome, output, picture, film, *summary);
    describe_preparation(outcome, loaded);
    if (!summary->interrupted) {
        describe_misses(outcome, *loaded.scene, picture, request.settings, film, *summary);
    }
    if (!has_samples(film)) {
        outcome.sentence = "interrupted before there was anything to save\n";
        return failed(std::move(outcome), ExitCode::interrupted);
    }
    if (request.denoise) {
        denoise(request, film, outcome);
    }
    const double exposure = run.exposure();
    outcome.facts["exposure"] = exposure;
    outcome.exposure = exposure;
    outcome.ambient = film.ambient;
    if (!request.exposure && exposure != 0.0) {
        outcome.sentence +=
            summary->light.empty()
                ? fmt::format(
                      "  exposure {:+} stops, ambient light {:.3g}; --exposure and "
                      "--ambient set them\n",
                      exposure, summary->ambient.x)
                : fmt::format("  exposure {:+} stops; --exposure sets it\n", exposure);
    }
    warn_of_lost_alpha(outcome, film, output);
    Diagnostics written = run.save();
    const CheckpointFile& checkpoint = run.checkpoint();
    if (has_errors(written)) {
        if (checkpoint.is_used()) {
            written.front().remedy = fmt::format(
                "correct that and continue with --resume from '{}'", checkpoint.file().string());
        }
        return failed(std::move(outcome), ExitCode::environment, written);
    }
    if (!summary->interrupted && checkpoint.is_used()) {
        checkpoint.remove();
    } else if (checkpoint.is_used()) {
        outcome.sentence +=
            fmt::format("  --resume continues from {}\n", checkpoint.file().string());
    }
    outcome.facts["output"] = output.is_stream() ? "-" : output.file().string();
    outcome.code = summary->interrupted ? ExitCode::interrupted : ExitCode::done;
    return outcome;
}

RenderReport render_picture(const RenderOptions& options, Request request,
                            const SceneOutput& target, Loaded& loaded,
                            const OutdatedTest& is_outdated = {}) {
    RenderReport outcome;
    add(outcome, request.warnings);
    loaded.environment = environment_files(options.light);
    if (has_errors(outcome.diagnostics)) {
        return failed(std::move(outcome), ExitCode::bad_input);
    }
    auto picture = load_all(options, request, target.scene, loaded, outcome);
    if (!picture) {
        return failed(std::move(outcome), ExitCode::bad_input);
    }
    if (const Diagnostics found = target.output.check_inputs(loaded.files()); has_errors(found)) {
        return failed(std::move(outcome), ExitCode::wrong_usage, found);
    }
    if (target.stereo) {
        auto views = camera::stereo_picture(*picture, *target.stereo, request.stereo->pair);
        add(outcome, views.diagnostics);
        if (!views) {
            return failed(std::move(outcome), ExitCode::bad_input);
        }
        picture = std::move(*views);
    }
    const render::DisplayFormat* const format = target.output.display_format();
    const render::FilmLayout layout = film_layout(request, *picture, format != nullptr);
    if (layout.layers.contains(render::LayerId::motion)) {
        add(outcome, add_frames(options, *loaded.scene, *picture, {layout.width, layout.height},
                                request.settings));
    }
    if (format == nullptr && render::film_bytes(layout) > request.job.film_bytes()) {
        if (request.job.shard) {
            return failed(std::move(outcome), ExitCode::bad_input,
                          {error("a shard of this size needs more memory than --film-memory allows",
                                 {}, "raise --film-memory, or render parts with --crop")});
        }
        return make_banded_picture(std::move(outcome), options, request, loaded, *picture, layout,
                                   target.output);
    }
    Result<render::Film> film = make_film(layout, request);
    if (!film) {
        return failed(std::move(outcome), ExitCode::bad_input, film.diagnostics);
    }
    if (format != nullptr) {
        if (const Diagnostics found =
                render::check_size(*format, film->window.width, film->window.height);
            has_errors(found)) {
            return failed(std::move(outcome), ExitCode::bad_input, found);
        }
    }
    return make_picture(std::move(outcome), options, request, loaded, *picture, std::move(*film),
                        target.output, is_outdated);
}

void show(const RenderReport& outcome, const RenderOptions& options) {
    report(outcome.diagnostics);
    if (!options.quiet && !has_errors(outcome.diagnostics)) {
        if (options.output == "-") {
            print_aside(outcome.sentence);
        } else {
            print_result(outcome.sentence);
        }
    }
}

ExitCode finish(const RenderReport& outcome, const RenderOptions& options) {
    if (options.json) {
        print_json(json_of(outcome));
    } else {
        show(outcome, options);
    }
    return outcome.code;
}

/// Renders again whenever a file changes that the picture is made of. A signal ends it.
ExitCode watch(const RenderOptions& options, Request request, const SceneOutput& target) {
    Loaded loaded;
    std::vector<fs::path> scene_files{target.scene};
    FileWatch environment(environment_files(options.light), request.since);
    for (;;) {
        const auto start = FileWatch::Time::clock::now();
        const bool reads_scene = !loaded.renderer;
        std::optional<FileWatch> cameras;
        std::optional<FileWatch> scene;
        auto next = std::chrono::steady_clock::now();
        const auto has_changed = [&] {
            // Asking for the states of files takes time.
            if (std::chrono::steady_clock::now() < next) {
                return false;
            }
            next = std::chrono::steady_clock::now() + std::chrono::milliseconds(100);
            // The files are known when the rendering begins.
            if (!cameras) {
                scene_files = loaded.scene->files;
                cameras.emplace(loaded.cameras.files(), start);
                scene.emplace(scene_files, reads_scene ? start : FileWatch::Time::max());
            }
            return cameras->has_changed() || scene->has_changed() || environment.has_changed();
        };
        const RenderReport outcome = render_picture(options, request, target, loaded, has_changed);
        if (!outcome.outdated) {
            finish(outcome, options);
            if (!finish_output()) {
                return ExitCode::environment;
            }
        }
        if (outcome.code == ExitCode::interrupted || outcome.code == ExitCode::wrong_usage) {
            return outcome.code;
        }
        cameras = cameras ? cameras : FileWatch(loaded.cameras.files(), start);
        scene = scene ? scene : FileWatch(scene_files, start);
        const Job job;
        if (!options.quiet && !outcome.outdated) {
            print_aside(fmt::format(
                "watching {}; Ctrl-C ends\n",
                counted(cameras->size() + scene->size() + environment.size(), "file", "files")));
        }
        if (!wait_for_change({*cameras, *scene, environment}, job.token())) {
            return ExitCode::interrupted;
        }
        loaded.cameras.reload();
        if (environment.has_changed()) {
            environment =
                FileWatch(environment_files(options.light), FileWatch::Time::clock::now());
            request.warnings = load_environment(options.light, request.settings);
        }
        if (scene->has_changed()) {
            loaded.renderer.reset();
            loaded.scene.reset();
        }
    }
}

/// Whether a picture is that of the other eye.
bool is_second_eye(const SceneOutput& target, const Request& request) {
    return request.stereo && request.stereo->has_two_files() &&
           target.stereo == request.stereo->formats.back();
}

/// Renders one picture after the other. A scene that fails does not stop the others. Both eyes see
/// a scene with the same exposure and ambient light, those of the first.
ExitCode render_all(const RenderOptions& options, const Request& request,
                    const std::vector<SceneOutput>& targets) {
    ExitCode code = ExitCode::done;
    nlohmann::json pictures = nlohmann::json::array();
    Loaded loaded;
    RenderReport outcome;
    for (const SceneOutput& target : targets) {
        Request wanted = request;
        if (is_second_eye(target, request)) {
            if (has_errors(outcome.diagnostics)) {
                continue;
            }
            wanted.exposure = outcome.exposure;
            // Only light without shadows follows the picture.
            if (!wanted.settings.ambient && outcome.ambient != render::Color3f(0.0F)) {
                wanted.settings.ambient = outcome.ambient;
            }
        } else {
            loaded = {std::move(loaded.cameras), {}, {}};
        }
        outcome = render_picture(options, wanted, target, loaded);
        if (options.json) {
            pictures.push_back(json_of(outcome));
            pictures.back()["scene"] = target.scene;
        } else {
            show(outcome, options);
        }
        code = code == ExitCode::done ? outcome.code : code;
        if (outcome.code == ExitCode::interrupted) {
            code = outcome.code;
            break;
        }
    }
    if (options.json) {
        print_json({{"pictures", pictures}, {"diagnostics", nlohmann::json::array()}});
    }
    return code;
}

ExitCode check_outputs(const RenderOptions& options, const std::vector<SceneOutput>& targets,
                       Diagnostics& diagnostics) {
    if (options.output == "-" && (options.json || options.watch)) {
        diagnostics.push_back(error(fmt::format("--output - and {} exclude each other",
                                                options.json ? "--json" : "--watch"),
                                    {}, "name a file for the picture"));
    } else if (options.output == "-" && targets.size() > 1) {
        diagnostics.push_back(error("--output - takes one picture, but there are several", {},
                                    "name a file for the pictures"));
    } else if (options.watch && targets.size() > 1 && options.stereo.format == "files") {
        diagnostics.push_back(error("--watch shows one picture, but --stereo files makes two", {},
                                    "write --stereo side_by_side"));
    } else if (options.watch && targets.size() > 1) {
        diagnostics.push_back(
            error("--watch shows one scene, but there are several", {}, "give one scene"));
    }
    check_shard(options, diagnostics);
    if (has_errors(diagnostics)) {
        return ExitCode::wrong_usage;
    }
    for (const SceneOutput& target : targets) {
        if (const ExitCode code = target.output.check(diagnostics); code != ExitCode::done) {
            return code;
        }
    }
    return ExitCode::done;
}

ExitCode render_command(const RenderOptions& options) {
    RenderReport outcome;
    Request request = read_request(options, outcome.diagnostics);
    const std::vector<SceneOutput> targets =
        scene_outputs(options, request.stereo, outcome.diagnostics);
    outcome.code = check_outputs(options, targets, outcome.diagnostics);
    if (outcome.code != ExitCode::done) {
        return finish(outcome, options);
    }
    request.warnings = load_environment(options.light, request.settings);
    if (has_errors(request.warnings)) {
        return finish(failed(std::move(outcome), ExitCode::bad_input, request.warnings), options);
    }
    if (options.watch) {
        return watch(options, request, targets.front());
    }
    if (targets.size() > 1) {
        return render_all(options, request, targets);
    }
    Loaded loaded;
    return finish(render_picture(options, request, targets.front(), loaded), options);
}

}  // namespace

void add_render_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](CLI::App& command, RenderOptions& options) {
        options.command = &command;
        CLI::Option* scenes = command.add_option(
            "SCENE", options.scenes,
            scene_files_text() + "; several, or a pattern such as '*.glb', each give a picture");
        scenes->type_name("SCENE")->required()->take_all();
        scenes->check([&command, scenes](const std::string& word) {
            const bool wrong = scenes->results().size() > 1 && is_misplaced(command, word);
            return std::string(wrong ? "misplaced" : "");
        });
        add_scene_options(command, options);
        add_time_option(command, options.time);
        add_shutter_options(command, options.shutter);
        add_stereo_options(command, options.stereo);
        command
            .add_option_function<std::string>(
                "-o,--output", [&options](const std::string& file) { options.output = file; },
                "output file: .png, .jpg, .webp, .tif, or .exr with all layers; {scene} stands for "
                "the scene's name, and - is standard output (PNG) (default: {scene}.png)")
            ->type_name("FILE");
        add_picture_options(command, options);
        command.add_flag("--watch", options.watch,
                         "render again whenever a file of the camera or the scene changes");
        add_job_options(command, options.job);
        add_run_options(command, options);
        command.footer(
            "Examples:\n"
            "  balcony render room.glb -o room.png\n"
            "  balcony render room.glb --camera superelliptic --set gamma=1/2 -o walls.png\n"
            "  balcony render room.glb --camera my.cam:closeup --size 1920x1080 -s 64\n"
            "  balcony render filmed.gltf --camera scene:Front\n"
            "  balcony render room.glb --camera my.cam --watch\n"
            "  balcony render *.glb --camera panorama -o 'pictures/{scene}.jpg'\n"
            "\n"
            "Ctrl-C saves the partial picture; a second Ctrl-C ends at once.\n"
            "--resume continues.");
    };
    add_command<RenderOptions>(app, code, "render", "renders a scene through a camera",
                               render_command, describe);
}

}  // namespace balcony::cli
