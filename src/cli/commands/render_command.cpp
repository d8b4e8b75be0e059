// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/app.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/options/common_options.hpp"
#include "cli/options/picture_output.hpp"
#include "cli/options/render_options.hpp"
#include "cli/options/scene_argument.hpp"
#include "cli/report/json.hpp"
#include "cli/report/render_observer.hpp"
#include "cli/report/render_report.hpp"
#include "cli/report/report.hpp"
#include "cli/report/usage.hpp"

namespace balcony::cli {

namespace {

void show(const app::Report& outcome, const app::Request& request, bool quiet) {
    report(outcome.diagnostics);
    if (quiet || has_errors(outcome.diagnostics)) {
        return;
    }
    const std::string text = report_text(outcome, request);
    if (request.output == "-") {
        print_aside(text);
    } else {
        print_result(text);
    }
}

ExitCode finish(const app::Report& outcome, const app::Request& request,
                const RenderOptions& options) {
    if (options.json) {
        print_json(report_json(outcome));
    } else {
        show(outcome, request, options.quiet);
    }
    return exit_code_of(outcome.diagnostics, outcome.interrupted);
}

/// Renders again whenever a file changes that the picture is made of. A signal ends it.
ExitCode watch(const RenderOptions& options, const app::Request& request) {
    RenderObserver observer(options.quiet || options.json);
    bool good = true;
    const app::Report last = app::watch(
        request, observer.observer(),
        [&](const app::Report& outcome) {
            observer.clear();
            finish(outcome, request, options);
            good = finish_output();
            if (!good) {
                observer.stop();
            }
        },
        [&](std::size_t files) {
            if (!options.quiet) {
                print_aside(
                    fmt::format("watching {}; Ctrl-C ends\n", counted(files, "file", "files")));
            }
        },
        observer.token());
    return good ? exit_code_of(last.diagnostics, last.interrupted) : ExitCode::environment;
}

/// Whether a picture is that of the other eye.
bool is_second_eye(const app::Request& picture, const app::Request& request) {
    return request.stereo.has_two_files() &&
           picture.stereo.formats.front() == request.stereo.formats.back();
}

/// Renders one picture after the other. A scene that fails does not stop the others.
ExitCode render_all(const RenderOptions& options, const app::Request& request,
                    const std::vector<app::Request>& wanted) {
    ExitCode code = ExitCode::done;
    nlohmann::json pictures = nlohmann::json::array();
    app::Session session;
    app::Report outcome;
    for (app::Request picture : wanted) {
        if (is_second_eye(picture, request)) {
            if (has_errors(outcome.diagnostics)) {
                continue;
            }
            hold_look(outcome, picture);
        }
        RenderObserver observer(options.quiet || options.json);
        outcome = session.render(picture, observer.observer(), observer.token());
        observer.clear();
        if (options.json) {
            pictures.push_back(report_json(outcome));
            pictures.back()["scene"] = picture.scene;
        } else {
            show(outcome, picture, options.quiet);
        }
        const ExitCode own = exit_code_of(outcome.diagnostics, outcome.interrupted);
        code = code == ExitCode::done || own == ExitCode::interrupted ? own : code;
        if (own == ExitCode::interrupted) {
            break;
        }
    }
    if (options.json) {
        print_json({{"pictures", pictures}, {"diagnostics", nlohmann::json::array()}});
    }
    return code;
}

void check_outputs(const RenderOptions& options, const std::vector<app::Request>& pictures,
                   Diagnostics& found) {
    const auto refuse_both = [&found](const std::string& what, const std::string& remedy) {
        found.push_back(error(Kind::usage, what, remedy));
    };
    if (options.output == "-" && (options.json || options.watch)) {
        refuse_both(fmt::format("--output - and {} exclude each other",
                                options.json ? "--json" : "--watch"),
                    "name a file for the picture");
    } else if (options.output == "-" && pictures.size() > 1) {
        refuse_both("--output - takes one picture, but there are several",
                    "name a file for the pictures");
    } else if (options.watch && pictures.size() > 1 && options.stereo.format == "files") {
        refuse_both("--watch shows one picture, but --stereo files makes two",
                    "write --stereo side_by_side");
    } else if (options.watch && pictures.size() > 1) {
        refuse_both("--watch shows one scene, but there are several", "give one scene");
    }
    if (!options.job.shard.empty() && (options.output == "-" || options.watch)) {
        refuse_both(fmt::format("--shard and {} exclude each other",
                                options.watch ? "--watch" : "--output -"),
                    "name a file for the picture that the shards make");
    }
}

ExitCode render_command(const RenderOptions& options) {
    app::Report refused;
    Diagnostics& found = refused.diagnostics;
    const app::Request request = read_request(options, found);
    const std::vector<app::Request> pictures = pictures_of(options, request, found);
    check_outputs(options, pictures, found);
    if (has_errors(found)) {
        finish(refused, request, options);
        return ExitCode::wrong_usage;
    }
    for (const app::Request& picture : pictures) {
        const Diagnostics output = check_output(picture.output);
        found.insert(found.end(), output.begin(), output.end());
        if (has_errors(found)) {
            return finish(refused, request, options);
        }
    }
    if (options.watch) {
        return watch(options, pictures.front());
    }
    if (pictures.size() > 1) {
        return render_all(options, request, pictures);
    }
    RenderObserver observer(options.quiet || options.json);
    app::Session session;
    const app::Report outcome =
        session.render(pictures.front(), observer.observer(), observer.token());
    observer.clear();
    return finish(outcome, pictures.front(), options);
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
