// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// balcony animate: the frames of an animation, as a sequence of pictures or a film.

#include <algorithm>
#include <cmath>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/bands.hpp"
#include "balcony/motion.hpp"
#include "cli/animation/animation_film.hpp"
#include "cli/animation/animation_options.hpp"
#include "cli/animation/frame_loop.hpp"
#include "cli/animation/turntable.hpp"
#include "cli/commands/command.hpp"
#include "cli/frame_pictures.hpp"
#include "cli/interruption.hpp"
#include "cli/loaded_picture.hpp"
#include "cli/options/option_values.hpp"
#include "cli/options/scene_argument.hpp"
#include "cli/render_request.hpp"
#include "cli/report/json.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

// As long as the longest of the scene's animations, or five seconds of a turntable.
Result<FrameNumbers> default_frames(const scene::Scene& scene, const AnimationRequest& request) {
    constexpr double turntable_seconds = 5.0;
    constexpr double rounding = 1e-6;
    double frames = 0.0;
    if (scene.motion) {
        for (const scene::Animation& animation : scene.motion->animations) {
            frames = std::max(frames,
                              std::floor(animation.duration / request.frame_time + rounding) + 1.0);
        }
    }
    if (frames == 0.0 && request.turntable) {
        frames = std::max(std::round(turntable_seconds / request.frame_time), 1.0);
    }
    if (frames == 0.0) {
        return error("nothing tells how many frames there are, since the scene has no animation",
                     {}, "add --frames 1-240");
    }
    FrameNumbers numbers(
        static_cast<std::size_t>(std::min(frames, static_cast<double>(max_frame))));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        numbers[i] = i + 1;
    }
    return numbers;
}

Diagnostics check_shards(const AnimationRequest& request, const FrameNumbers& frames) {
    if (!request.shard || request.shard->count <= frames.size() * request.parts_per_frame) {
        return {};
    }
    const std::size_t shards = request.shard->count;
    return {error(fmt::format("there are {} shards, but only {}", shards,
                              counted(frames.size() * request.parts_per_frame,
                                      request.parts_per_frame > 1 ? "part of a frame" : "frame",
                                      request.parts_per_frame > 1 ? "parts of frames" : "frames")),
                  {},
                  fmt::format("use at most as many shards as frames, or divide each frame: "
                              "--parts-per-frame {}",
                              (shards + frames.size() - 1) / frames.size()))};
}

// The film's pixels are in pairs, so a chosen size becomes even.
render::FilmLayout layout_of(const AnimateOptions& options, const AnimationRequest& animation,
                             const Request& request, const camera::Picture& picture,
                             RenderReport& outcome) {
    const bool displayed = PictureOutput(animation.pattern->file(1)).display_format() != nullptr;
    render::FilmLayout layout = film_layout(request, picture, displayed);
    if (!animation.film || !has_even_sides(animation.film->file)) {
        return layout;
    }
    const SizeWords& size = options.render.size;
    if (size.size.empty() && size.width.empty() && size.height.empty() && !layout.window) {
        const auto even = [](std::size_t side) { return std::max<std::size_t>(side / 2 * 2, 2); };
        layout.width = even(layout.width);
        layout.height = even(layout.height);
    }
    const render::Region shown =
        layout.window.value_or(render::Region{0, 0, layout.width, layout.height});
    if (shown.width % 2 != 0 || shown.height % 2 != 0) {
        add(outcome, {warning(fmt::format("the film has sides of an even number of pixels: {} x {}",
                                          shown.width / 2 * 2, shown.height / 2 * 2),
                              {}, "choose even sides with --size")});
    }
    return layout;
}

ExitCode check_output(const AnimateOptions& options, const AnimationRequest& request,
                      Diagnostics& diagnostics) {
    if (has_errors(diagnostics)) {
        return ExitCode::wrong_usage;
    }
    if (!request.film) {
        return PictureOutput(request.pattern->file(1)).check(diagnostics);
    }
    const Diagnostics found = check_film(*request.film);
    add_film_folder(*request.film, diagnostics);
    diagnostics.insert(diagnostics.end(), found.begin(), found.end());
    return has_errors(diagnostics)
               ? (options.words.crf.empty() ? ExitCode::environment : ExitCode::wrong_usage)
               : ExitCode::done;
}

// Numbers that are longer than their place no longer sort by name.
void warn_of_long_numbers(const FramePattern& pattern, const FrameNumbers& frames,
                          RenderReport& outcome) {
    const std::size_t digits = fmt::format("{}", frames.back()).size();
    if (pattern.digits() > 1 && digits > pattern.digits()) {
        add(outcome, {warning(fmt::format("frame {} has more digits than '{}', so the names of "
                                          "the files do not sort by frame",
                                          frames.back(), pattern.text()),
                              {}, fmt::format("write {}", std::string(digits, '#')))});
    }
}

void describe(RenderReport& outcome, const AnimateOptions& options, const AnimationRequest& request,
              const FrameNumbers& frames) {
    const auto& facts = outcome.facts;
    const std::string name = options.render.output.value_or("");
    const std::string skipped =
        facts["skipped"] > 0 ? fmt::format(", {} finished before", facts["skipped"].get<int>())
                             : "";
    const std::string done = fmt::format("{} rendered in {}{}",
                                         counted(facts["rendered"].get<std::size_t>(),
                                                 request.parts_per_frame > 1 ? "part" : "frame",
                                                 request.parts_per_frame > 1 ? "parts" : "frames"),
                                         duration_text(facts["seconds"].get<double>()), skipped);
    if (outcome.code == ExitCode::interrupted) {
        outcome.sentence = fmt::format("interrupted: {}; the same command continues\n", done);
        return;
    }
    outcome.sentence =
        fmt::format("{}: frames {} of {} x {} pixels, {}\n", printable(name), text_of(frames),
                    facts["width"].get<int>(), facts["height"].get<int>(), done);
    if (!options.render.exposure.empty() && options.render.exposure == "auto" &&
        facts["exposure"].get<double>() != 0.0) {
        outcome.sentence +=
            fmt::format("  exposure {:+} stops, that of frame 1; --exposure sets it\n",
                        facts["exposure"].get<double>());
    }
    if (request.shard || request.parts_per_frame > 1) {
        outcome.sentence += fmt::format("  when all shards are done: balcony merge {}\n",
                                        request.film ? name : "'" + name + "'");
    }
}

// What two eyes see of a picture, in one picture.
std::optional<camera::Picture> stereo_view(const Request& request, camera::Picture picture,
                                           RenderReport& outcome) {
    if (!request.stereo) {
        return picture;
    }
    auto views =
        camera::stereo_picture(picture, request.stereo->formats.front(), request.stereo->pair);
    add(outcome, views.diagnostics);
    return std::move(views.value);
}

// The picture of a turntable. Without a camera, it shows the whole scene, or object, from all
// sides.
std::optional<camera::Picture> turned_round(const AnimateOptions& options, const Request& request,
                                            const AnimationRequest& animation,
                                            const FrameNumbers& frames, const scene::Scene& scene,
                                            camera::Picture picture, RenderReport& outcome) {
    const Result<render::SceneExtent> extent = render::measure_scene(scene, animation.around);
    add(outcome, extent.diagnostics);
    if (!extent) {
        return std::nullopt;
    }
    if (options.render.camera.empty()) {
        const auto [width, height] = request.size.resolve(camera::default_aspect);
        const Result<camera::Picture> whole = turntable_picture(
            scene, *extent, static_cast<double>(width) / static_cast<double>(height));
        add(outcome, whole.diagnostics);
        if (!whole) {
            return std::nullopt;
        }
        picture = whole->with_fit(request.size.fit);
    }
    return picture.with_turn(turn_of(*extent, animation, frames));
}

Diagnostics check_inputs(const FramePattern& pattern, const std::vector<fs::path>& inputs) {
    Diagnostics found;
    for (const fs::path& input : inputs) {
        if (const auto frame = pattern.number_of_file(input.filename().string())) {
            const Diagnostics one = PictureOutput(pattern.file(*frame)).check_inputs({input});
            found.insert(found.end(), one.begin(), one.end());
        }
    }
    return found;
}

RenderReport animate(const AnimateOptions& options, Request request,
                     const AnimationRequest& animation, RenderReport outcome) {
    request.settings.time = animation.time_of(1);
    Loaded loaded;
    loaded.environment = environment_files(options.render.light);
    auto picture = load_all(options.render, request, options.words.scene, loaded, outcome);
    if (!picture) {
        return failed(std::move(outcome), ExitCode::bad_input);
    }
    add(outcome, check_inputs(*animation.pattern, loaded.files()));
    Result<FrameNumbers> frames = animation.frames ? Result<FrameNumbers>(*animation.frames)
                                                   : default_frames(*loaded.scene, animation);
    add(outcome, frames.diagnostics);
    if (!frames || has_errors(outcome.diagnostics)) {
        return failed(std::move(outcome), ExitCode::wrong_usage);
    }
    if (const Diagnostics found = check_shards(animation, *frames); has_errors(found)) {
        return failed(std::move(outcome), ExitCode::wrong_usage, found);
    }
    warn_of_long_numbers(*animation.pattern, *frames, outcome);
    if (request.stereo && has_moving_camera(options.render, *loaded.scene)) {
        return failed(std::move(outcome), ExitCode::bad_input,
                      {error("--stereo cannot follow a camera of the scene that moves", {},
                             "name a camera of a file with --camera")});
    }
    if (animation.turntable) {
        picture =
            turned_round(options, request, animation, *frames, *loaded.scene, *picture, outcome);
        if (!picture) {
            return failed(std::move(outcome), ExitCode::bad_input);
        }
    }
    picture = stereo_view(request, *picture, outcome);
    if (!picture) {
        return failed(std::move(outcome), ExitCode::bad_input);
    }
    const render::FilmLayout layout = layout_of(options, animation, request, *picture, outcome);
    if (render::film_bytes(layout) > request.job.film_bytes()) {
        return failed(std::move(outcome), ExitCode::bad_input,
                      {error("a frame of this size needs more memory than --film-memory allows", {},
                             "raise --film-memory, or make the frames smaller")});
    }
    const Job interruption;
    FrameLoop loop(options, animation, request, loaded, std::move(*picture), layout);
    outcome = loop.run(std::move(outcome), *frames, interruption.token());
    if (outcome.code != ExitCode::done && outcome.code != ExitCode::interrupted) {
        return outcome;
    }
    describe(outcome, options, animation, *frames);
    outcome.facts["output"] = options.render.output.value_or("");
    if (outcome.code == ExitCode::done && animation.film && !animation.shard &&
        animation.parts_per_frame == 1) {
        ProgressDisplay display(options.render.quiet || options.render.json);
        make_film_of_frames(*animation.film, *animation.pattern, *frames, !animation.keep_frames,
                            display, outcome, interruption.token());
    }
    return outcome;
}

ExitCode finish(const RenderReport& outcome, const RenderOptions& options) {
    if (options.json) {
        print_json(json_of(outcome));
        return outcome.code;
    }
    report(outcome.diagnostics);
    if (!options.quiet && !has_errors(outcome.diagnostics)) {
        print_result(outcome.sentence);
    }
    return outcome.code;
}

ExitCode animate_command(const AnimateOptions& options) {
    RenderReport outcome;
    Request request = read_request(options.render, outcome.diagnostics);
    const AnimationRequest animation = read_animation(options, outcome.diagnostics);
    if (request.stereo && request.stereo->has_two_files()) {
        outcome.diagnostics.push_back(error("an animation is one film or sequence, not two", {},
                                            "write --stereo left, and then --stereo right"));
    }
    outcome.code = check_output(options, animation, outcome.diagnostics);
    if (outcome.code != ExitCode::done) {
        return finish(outcome, options.render);
    }
    request.warnings = load_environment(options.render.light, request.settings);
    add(outcome, request.warnings);
    if (has_errors(request.warnings)) {
        return finish(failed(std::move(outcome), ExitCode::bad_input), options.render);
    }
    return finish(animate(options, std::move(request), animation, std::move(outcome)),
                  options.render);
}

}  // namespace

void add_animate_command(CLI::App& app, ExitCode& code) {
    const auto describe_options = [](CLI::App& command, AnimateOptions& options) {
        options.render.command = &command;
        command.add_option("SCENE", options.words.scene, scene_files_text())
            ->type_name("SCENE")
            ->required();
        add_scene_options(command, options.render);
        add_shutter_options(command, options.render.shutter);
        add_stereo_options(command, options.render.stereo);
        add_animation_options(command, options);
        add_picture_options(command, options.render);
        add_run_options(command, options.render);
        add_safety_options(command, options.render.job);
        command.footer(
            "Examples:\n"
            "  balcony animate room.glb --turntable --frames 1-120 -o room.mp4\n"
            "  balcony animate room.glb --camera my.cam --frames 1-240 -o 'room.####.exr'\n"
            "  balcony animate room.glb --camera my.cam --frames 1-48 --shutter 180deg -o "
            "room.webm\n"
            "  balcony animate room.glb --frames 1-48 --shard 3/4 -o room.mp4\n"
            "\n"
            "The same command continues after an interruption: finished frames are kept.");
    };
    add_command<AnimateOptions>(app, code, "animate",
                                "renders a film or a sequence of pictures of a scene",
                                animate_command, describe_options);
}

}  // namespace balcony::cli
