// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "balcony/app.hpp"
#include "balcony/names.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/options/picture_output.hpp"
#include "cli/report/render_observer.hpp"
#include "cli/report/render_report.hpp"
#include "cli/report/usage.hpp"

namespace balcony::cli {

namespace {

struct RenderOptions {
    std::vector<std::string> scenes;
    std::optional<std::string> output;
    app::Request request;  ///< But for scenes and outputs.
    bool watch = false;
    Manner manner;
    std::vector<app::Request> pictures;  ///< Made of all these.
};

/// Renders again whenever a file changes that the picture is made of. A signal ends it.
ExitCode watch(const app::Request& request, const Manner& manner) {
    RenderObserver observer(manner);
    bool good = true;
    const app::Report last = app::watch(
        request, observer.observer(),
        [&](const app::Report& outcome) {
            observer.clear();
            give(answer_of(outcome, request), manner);
            good = finish_output();
            if (!good) {
                observer.stop();
            }
        },
        [&](std::size_t files) {
            if (!manner.quiet) {
                print_aside(fmt::format("watching {}; Ctrl-C ends\n", counted(files, "file")));
            }
        },
        observer.token());
    // main() says that standard output cannot be written to.
    return exit_code_of(last.diagnostics, good && last.interrupted);
}

Answer render(app::Session& session, const app::Request& picture, app::Report& report,
              const Manner& manner) {
    RenderObserver observer(manner);
    report = session.render(picture, observer.observer(), observer.token());
    return answer_of(report, picture);
}

/// Whether a picture is that of the other eye.
bool is_second_eye(const app::Request& picture, const app::Request& request) {
    return request.stereo.has_two_files() &&
           picture.stereo.formats.front() == request.stereo.formats.back();
}

/// Renders one picture after the other. A scene that fails does not stop the others.
ExitCode render_all(const RenderOptions& options) {
    Answer all;
    nlohmann::json& pictures = all.facts["pictures"] = nlohmann::json::array();
    app::Session session;
    app::Report report;
    for (app::Request picture : options.pictures) {
        if (is_second_eye(picture, options.request)) {
            if (has_errors(report.diagnostics)) {
                continue;
            }
            hold_look(report, picture);
        }
        const Answer answer = render(session, picture, report, options.manner);
        all.add(answer.diagnostics);
        if (options.manner.json) {
            pictures.push_back(to_json(answer));
            pictures.back()["scene"] = picture.scene;
        } else {
            give(answer, options.manner);
        }
        if (answer.interrupted) {
            all.interrupted = true;
            break;
        }
    }
    if (options.manner.json) {
        print_json(to_json(all));
    }
    return exit_code_of(all.diagnostics, all.interrupted);
}

void check_outputs(const RenderOptions& options, Diagnostics& found) {
    const bool to_stream = options.output == "-";
    const bool several = options.pictures.size() > 1;
    const auto refuse_both = [&found](const std::string& what, const std::string& remedy) {
        found.push_back(error(Kind::usage, what, remedy));
    };
    if (to_stream && (options.manner.json || options.watch)) {
        refuse_both(fmt::format("--output - and {} exclude each other",
                                options.manner.json ? "--json" : "--watch"),
                    "name a file for the picture");
    } else if (to_stream && several) {
        refuse_both("--output - takes one picture, but there are several",
                    "name a file for the pictures");
    } else if (options.watch && several && options.request.stereo.has_two_files()) {
        refuse_both("--watch shows one picture, but --stereo files makes two",
                    "write --stereo side_by_side");
    } else if (options.watch && several) {
        refuse_both("--watch shows one scene, but there are several", "give one scene");
    }
    if (options.request.job.shard && (to_stream || options.watch)) {
        refuse_both(fmt::format("--shard and {} exclude each other",
                                options.watch ? "--watch" : "--output -"),
                    "name a file for the picture that the shards make");
    }
}

ExitCode render_command(const RenderOptions& options) {
    const std::vector<app::Request>& pictures = options.pictures;
    for (const app::Request& picture : pictures) {
        if (const Diagnostics found = check_output(picture.output); has_errors(found)) {
            return give({found}, options.manner);
        }
    }
    if (options.watch) {
        return watch(pictures.front(), options.manner);
    }
    if (pictures.size() > 1) {
        return render_all(options);
    }
    app::Session session;
    app::Report report;
    return give(render(session, pictures.front(), report, options.manner), options.manner);
}

app::Option<RenderOptions> output_row() {
    const auto name = app::converted<std::optional<std::string>>(
        text(OptionType::file), [](const std::string& file) { return std::optional(file); },
        [](const std::optional<std::string>& file) { return file.value_or(""); });
    return option({.name = "--output",
                   .letter = "-o",
                   .others = {"--out"},
                   .placeholder = "FILE",
                   .meaning = "output file: .png, .jpg, .webp, .tif, or .exr with all layers; "
                              "{scene} stands for the scene's name, and - is standard output (PNG) "
                              "(default: {scene}.png)",
                   .effect = Effect::run},
                  name, &RenderOptions::output);
}

app::Options<RenderOptions> render_rows() {
    app::Options<RenderOptions> all{
        {app::words({.name = "SCENE",
                     .meaning = scene_files_text() +
                                "; several, or a pattern such as '*.glb', each give a picture",
                     .required = true,
                     .effect = Effect::run,
                     .type = OptionType::scene},
                    &RenderOptions::scenes),
         output_row()}};
    all.add(&RenderOptions::request, app::request_options());
    all.add({{flag({.name = "--watch",
                    .meaning = "render again whenever a file of the camera or the scene changes",
                    .effect = Effect::run},
                   true, &RenderOptions::watch)}});
    all.add(manner_options(&RenderOptions::manner));
    all.checks.emplace_back([](RenderOptions& options, const app::GivenWords&, Diagnostics& found) {
        options.pictures = pictures_of(options.scenes, options.output, options.request, found);
        check_outputs(options, found);
    });
    return all;
}

}  // namespace

void add_render_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, RenderOptions& options) {
        command.add(render_rows(), options);
        command.show_first({"--output", "--camera", "--set", "--fit", "--no-fit", "--fit-to",
                            "--from", "--time", "--size", "--crop", "--samples", "--integrator",
                            "--environment", "--exposure", "--background", "--denoise", "--resume",
                            "--watch", "--quiet"});
        CLI::Option* const scenes = command.get_option("SCENE");
        scenes->check([&command, scenes](const std::string& word) {
            const bool wrong = scenes->results().size() > 1 && is_misplaced(command, word);
            return std::string(wrong ? "misplaced" : "");
        });
        command.footer(
            "Examples:\n"
            "  balcony render room.glb -o room.png\n"
            "  balcony render room.glb --camera superelliptic --set gamma=1/2 -o walls.png\n"
            "  balcony render room.glb --camera my.cam:closeup --fit --size 1920x1080 -s 64\n"
            "  balcony render filmed.gltf --camera scene:Front\n"
            "  balcony render room.glb --camera my.cam --fit --watch\n"
            "  balcony render *.glb --camera panorama -o 'pictures/{scene}.jpg'\n"
            "\n"
            "Ctrl-C saves the partial picture; a second Ctrl-C ends at once.\n"
            "--resume continues.");
    };
    add_command<RenderOptions>(app, code, "render", "renders a scene through a camera",
                               render_command, describe);
}

}  // namespace balcony::cli
