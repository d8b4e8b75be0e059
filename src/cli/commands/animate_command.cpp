// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// balcony animate: the frames of an animation, as a sequence of pictures or a film.

#include "balcony/animation.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/render_observer.hpp"
#include "cli/report/render_report.hpp"

namespace balcony::cli {

namespace {

struct AnimateOptions {
    app::AnimationRequest animation;
    Manner manner;
};

ExitCode animate(const AnimateOptions& options) {
    const app::AnimationRequest& animation = options.animation;
    app::AnimationReport report;
    report.diagnostics = app::prepare_output(animation);
    if (!has_errors(report.diagnostics)) {
        RenderObserver observer(options.manner);
        report = app::animate(animation, observer.observer(), observer.token());
    }
    return give(answer_of(report, animation), options.manner);
}

}  // namespace

void add_animate_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, AnimateOptions& options) {
        app::Options<app::Request> scene{
            {scene_argument(&app::Request::scene, scene_files_text())}};
        app::Options<app::AnimationRequest> animation;
        animation.add(&app::AnimationRequest::picture, std::move(scene));
        animation.add(app::animation_options());
        app::Options<AnimateOptions> all;
        all.add(&AnimateOptions::animation, std::move(animation));
        all.add(manner_options(&AnimateOptions::manner));
        command.add(std::move(all), options);
        command.show_first({"--output", "--camera", "--set", "--fit", "--frames", "--duration",
                            "--turntable", "--fps", "--shutter", "--size", "--samples",
                            "--integrator", "--environment", "--exposure", "--denoise",
                            "--overwrite", "--shard", "--quiet"});
        command.footer(
            "Examples:\n"
            "  balcony animate room.glb --turntable --frames 1-120 -o room.mp4\n"
            "  balcony animate room.glb -c my.cam --fit --frames 1-240 -o 'room.####.exr'\n"
            "  balcony animate room.glb -c my.cam --fit --frames 1-48 --shutter 180deg -o "
            "room.webm\n"
            "  balcony animate room.glb --frames 1-48 --shard 3/4 -o room.mp4\n"
            "\n"
            "The same command continues after an interruption: finished frames are kept.");
    };
    add_command<AnimateOptions>(app, code, "animate",
                                "renders a film or a sequence of pictures of a scene", animate,
                                describe);
}

}  // namespace balcony::cli
