// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/display_file.hpp"
#include "balcony/film.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/photo_options.hpp"
#include "cli/report/json.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

struct WarpOptions {
    std::string photo;
    PhotoOptions view;
    std::string output;
    bool quiet = false;
    bool json = false;
};

struct WarpOutcome {
    ExitCode code = ExitCode::done;
    Diagnostics diagnostics{};
    std::optional<bridge::StMap> map{};
    bridge::StMapWritten written{};
};

void add_found(WarpOutcome& outcome, const Diagnostics& found, ExitCode code) {
    outcome.diagnostics.insert(outcome.diagnostics.end(), found.begin(), found.end());
    outcome.code = has_errors(found) ? code : outcome.code;
}

void check_warp_output(const WarpOptions& options, WarpOutcome& outcome) {
    std::error_code failed;
    if (fs::equivalent(options.output, options.photo, failed) && !failed) {
        add_found(outcome,
                  {error(fmt::format("'{}' is the photo and would be overwritten", options.output),
                         {}, "name another file with --output")},
                  ExitCode::wrong_usage);
        return;
    }
    const bool known = render::display_format(options.output) != nullptr ||
                       fs::path(options.output).extension() == ".exr";
    add_found(outcome, render::check_output(options.output),
              known ? ExitCode::environment : ExitCode::wrong_usage);
}

WarpOutcome warp_file(const WarpOptions& options) {
    WarpOutcome outcome;
    Diagnostics usage;
    const PhotoRequest request = read_photo_request(options.view, usage);
    add_found(outcome, usage, ExitCode::wrong_usage);
    if (outcome.code == ExitCode::done) {
        check_warp_output(options, outcome);
    }
    if (outcome.code != ExitCode::done) {
        return outcome;
    }
    const auto photo = bridge::Photo::load(options.photo);
    add_found(outcome, photo.diagnostics, ExitCode::bad_input);
    if (!photo) {
        return outcome;
    }
    auto map = make_st_map(options.view, request, std::array{photo->width(), photo->height()});
    add_found(outcome, map.diagnostics, ExitCode::bad_input);
    outcome.map = std::move(map.value);
    if (outcome.map) {
        const Job job;
        outcome.written = warp_photo(*outcome.map, *photo, options.output, job.token());
        add_found(outcome, outcome.written.problems, ExitCode::environment);
        if (outcome.code == ExitCode::done && !outcome.written.complete) {
            outcome.code = ExitCode::interrupted;
        }
    }
    return outcome;
}

ExitCode warp(const WarpOptions& options) {
    const WarpOutcome outcome = warp_file(options);
    const bool done = outcome.code == ExitCode::done;
    if (options.json) {
        nlohmann::json document{{"output", nullptr}, {"diagnostics", to_json(outcome.diagnostics)}};
        if (done) {
            document["output"] = options.output;
            document["width"] = outcome.map->width();
            document["height"] = outcome.map->height();
            document["valid"] = outcome.written.valid;
        }
        print_json(document);
        return outcome.code;
    }
    report(outcome.diagnostics);
    if (done && !options.quiet) {
        print_result(fmt::format("{}: {} x {} pixels, {} of them in the photo\n",
                                 printable(options.output), outcome.map->width(),
                                 outcome.map->height(), outcome.written.valid));
    }
    return outcome.code;
}

}  // namespace

void add_warp_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](CLI::App& command, WarpOptions& options) {
        command
            .add_option("PHOTO", options.photo,
                        "image: PNG, JPEG, WebP, TIFF, OpenEXR, Radiance HDR, TGA or BMP")
            ->type_name("FILE")
            ->required();
        command
            .add_option("-c,--camera", options.view.camera,
                        "camera of the new picture: its file and the NAME of a camera in it "
                        "(default: the last), or a built-in camera")
            ->type_name("FILE[:NAME]")
            ->required();
        command
            .add_option("-o,--output", options.output,
                        "output file: .png, .jpg, .webp, .tif, or .exr")
            ->type_name("FILE")
            ->required();
        add_photo_options(command, options.view);
        add_quiet_option(command, options.quiet);
        command.add_flag("--json", options.json, "print facts and diagnostics as JSON");
        command.footer(
            "Examples:\n"
            "  balcony warp photo.png --from panorama --camera pinhole --set yaw=30deg -o "
            "view.png\n"
            "  balcony warp photo.png --from panorama --camera fisheye --set pitch=90deg -o "
            "sky.png");
    };
    add_command<WarpOptions>(app, code, "warp", "warps a photo into the picture of another camera",
                             warp, describe);
}

}  // namespace balcony::cli
