// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "balcony/inputs.hpp"
#include "balcony/lang.hpp"
#include "balcony/language_service.hpp"
#include "balcony/names.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/report.hpp"
#include "studio/serve.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

struct StudioOptions {
    std::string camera;
    app::Request request;
    std::size_t port = 0;
    std::string token_file;
    bool read_only = false;
    std::vector<std::string> picture_words;  ///< The options of a picture, as they were given.
    Manner manner;
};

/// The file that is edited if no other one is named.
constexpr std::string_view default_file = "camera.cam";
constexpr std::string_view default_camera = "pinhole";

bool is_built_in(const std::string& camera) { return !lang::family_of(camera).empty(); }

/// Which file is edited, and what its text is if it is not there: that of a built-in camera, which
/// the scene places.
Diagnostics choose_camera(const StudioOptions& options, studio::Options& made) {
    std::string base(default_camera);
    made.file = default_file;
    if (is_built_in(options.camera)) {
        base = options.camera;
        made.file = base + ".cam";
    } else if (!options.camera.empty()) {
        const Result<app::CameraArgument> wanted = app::read_camera(options.camera, {});
        if (!wanted) {
            return wanted.diagnostics;
        }
        made.file = wanted->file;
        made.camera = wanted->name;
    }
    std::error_code ignored;
    if (fs::exists(made.file, ignored)) {
        return {};
    }
    made.new_text = lang::built_in_text(base);
    if (!made.request.placement.fit) {
        made.request.placement.fit = true;
    }
    return {};
}

ExitCode serve(const StudioOptions& options) {
    studio::Options made{.request = options.request,
                         .is_read_only = options.read_only,
                         .words = options.picture_words,
                         .port = static_cast<std::uint16_t>(options.port),
                         .token_file = options.token_file};
    Diagnostics found = choose_camera(options, made);
    if (has_errors(found)) {
        return give({found}, options.manner);
    }
    if (options.request.stereo.has_two_files()) {
        return give({{error(Kind::usage, "the studio shows one picture, not two files",
                            "choose another --stereo, such as side_by_side")}},
                    options.manner);
    }
    if (const app::SizeRequest& size = options.request.size; size.width || size.height) {
        const auto [width, height] = size.resolve(16.0 / 9.0);
        made.size = {width, height};
    }
    made.on_ready = [&options](const std::string& address) {
        if (options.manner.json) {
            print_json({{"address", address}});
        } else {
            print_result(address + "\n");
        }
        static_cast<void>(finish_output());
        if (!options.manner.quiet && !options.manner.json) {
            print_aside("the studio is at this address; Ctrl-C ends it\n");
        }
    };
    Interruptible work;
    found = studio::serve(made, work.token());
    report(found);
    return exit_code_of(found, work.token().stop_requested());
}

/// The options of a picture that a view of it has. Others are about files, or about pictures that
/// are not shown in a page.
app::Options<app::Request> view_options() {
    app::Options<app::Request> made = app::scene_options();
    made.rows.push_back(app::time_option(1e9, &app::Request::settings, &render::Settings::time));
    made.add(&app::Request::shutter, app::shutter_options());
    made.add(&app::Request::stereo, app::stereo_options());
    made.add(app::picture_options());
    made.add(app::thread_options());
    made.leave_out({"--camera", "--set", "--solve", "--crop", "--scale", "--mm-per-pixel",
                    "--layers", "--dpi", "--denoise", "--denoiser", "--noise", "--motion-scale",
                    "--texture-memory"});
    return made;
}

/// The options of the picture, as they were given. A page has its own size.
void keep_words(const std::vector<app::Option<app::Request>>& rows, const app::GivenWords& given,
                StudioOptions& read) {
    for (const app::OptionInfo& row : rows) {
        const auto found = given.find(row.name);
        if (found == given.end() || row.name == "--size") {
            continue;
        }
        const bool is_flag = row.type == app::OptionType::flag;
        const std::vector<std::string>& words = found->second;
        const std::size_t step = is_flag ? words.size() : row.words;
        for (std::size_t i = 0; i < words.size(); i += step) {
            read.picture_words.push_back(row.name);
            if (!is_flag) {
                const auto begin = words.begin() + static_cast<std::ptrdiff_t>(i);
                read.picture_words.insert(read.picture_words.end(), begin,
                                          begin + static_cast<std::ptrdiff_t>(step));
            }
        }
    }
}

}  // namespace

void add_studio_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, StudioOptions& options) {
        app::Options<StudioOptions> all{
            {option({.name = "SCENE",
                     .meaning = scene_files_text(),
                     .required = true,
                     .effect = Effect::run},
                    text(OptionType::scene), &StudioOptions::request, &app::Request::scene),
             option(
                 {.name = "CAMERA",
                  .placeholder = "FILE[:NAME]",
                  .meaning = fmt::format("camera file that is edited, which may be a new one, or "
                                         "a built-in camera to begin with (default: {})",
                                         default_file)},
                 text(OptionType::camera), &StudioOptions::camera),
             option({.name = "--port",
                     .placeholder = "NUMBER",
                     .meaning = "where the server listens on this machine; 0 is a free port",
                     .effect = Effect::run},
                    app::count(0, 65535), &StudioOptions::port),
             option({.name = "--token-file",
                     .placeholder = "FILE",
                     .meaning = "file with the token of the address, which is made if it is not "
                                "there: so that a page finds a server that was started again",
                     .effect = Effect::run},
                    text(OptionType::file), &StudioOptions::token_file),
             flag({.name = "--read-only",
                   .meaning = "no file is written: for showing",
                   .effect = Effect::run},
                  true, &StudioOptions::read_only)}};
        app::Options<app::Request> of_picture = view_options();
        all.checks.emplace_back(
            [rows = of_picture.rows](StudioOptions& read, const app::GivenWords& given,
                                     Diagnostics&) { keep_words(rows, given, read); });
        all.add(&StudioOptions::request, std::move(of_picture));
        all.add(manner_options(&StudioOptions::manner, "print the address as JSON"));
        command.add(std::move(all), options);
        command.show_first({"--port", "--token-file", "--read-only", "--fit", "--no-fit",
                            "--fit-to", "--from", "--time", "--size", "--samples", "--integrator",
                            "--environment", "--exposure", "--background", "--quiet"});
        command.footer(
            "Examples:\n"
            "  balcony studio room.glb my.cam\n"
            "  balcony studio room.glb panorama\n"
            "\n"
            "Open the address that it prints in a browser of this machine. docs/studio.md\n"
            "describes the page and the protocol.");
    };
    add_command<StudioOptions>(
        app, code, "studio", "serves a page in which a camera is edited while its picture follows",
        serve, describe);
}

}  // namespace balcony::cli
