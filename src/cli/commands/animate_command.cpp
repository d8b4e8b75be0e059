// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// balcony animate: the frames of an animation, as a sequence of pictures or a film.

#include <nlohmann/json.hpp>

#include "balcony/animation.hpp"
#include "cli/animation/animation_options.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/scene_argument.hpp"
#include "cli/report/json.hpp"
#include "cli/report/render_observer.hpp"
#include "cli/report/render_report.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

ExitCode finish(const app::AnimationReport& outcome, const app::AnimationRequest& request,
                const RenderOptions& options) {
    if (options.json) {
        print_json(report_json(outcome, request));
    } else {
        report(outcome.diagnostics);
        if (!options.quiet && !has_errors(outcome.diagnostics)) {
            print_result(report_text(outcome, request));
        }
    }
    return exit_code_of(outcome.diagnostics, outcome.interrupted);
}

ExitCode animate_command(const AnimateOptions& options) {
    app::AnimationReport refused;
    const app::AnimationRequest request = read_animation(options, refused.diagnostics);
    if (has_errors(refused.diagnostics)) {
        finish(refused, request, options.render);
        return ExitCode::wrong_usage;
    }
    refused.diagnostics = app::prepare_output(request);
    if (has_errors(refused.diagnostics)) {
        return finish(refused, request, options.render);
    }
    RenderObserver observer(options.render.quiet || options.render.json);
    const app::AnimationReport outcome =
        app::animate(request, observer.observer(), observer.token());
    observer.clear();
    return finish(outcome, request, options.render);
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
