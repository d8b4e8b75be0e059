// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "balcony/display_file.hpp"
#include "balcony/film.hpp"
#include "balcony/inputs.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/options/photo_options.hpp"
#include "cli/report/st_map_report.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

struct WarpOptions {
    std::string photo;
    PhotoRequest view;
    std::string output;
    bool quiet = false;
    bool json = false;
};

void check_warp_output(const WarpOptions& options, StMapOutcome& outcome) {
    const bool known = render::display_format(options.output) != nullptr ||
                       fs::path(options.output).extension() == ".exr";
    outcome.add(render::check_output(options.output),
                known ? ExitCode::environment : ExitCode::wrong_usage);
}

StMapOutcome warp_file(const WarpOptions& options) {
    StMapOutcome outcome;
    check_warp_output(options, outcome);
    if (outcome.code != ExitCode::done) {
        return outcome;
    }
    const auto photo = bridge::Photo::load(options.photo);
    outcome.add(photo.diagnostics, ExitCode::bad_input);
    if (!photo) {
        return outcome;
    }
    lang::Workspace workspace;
    auto map = make_st_map(options.view, std::array{photo->width(), photo->height()}, workspace);
    outcome.add(map.diagnostics, ExitCode::bad_input);
    outcome.map = std::move(map.value);
    std::vector<fs::path> inputs = workspace.files();
    inputs.emplace_back(options.photo);
    outcome.add(app::check_overwrites(options.output, inputs), ExitCode::wrong_usage);
    if (outcome.code == ExitCode::done) {
        const Job job;
        outcome.add(warp_photo(*outcome.map, *photo, options.output, job.token()));
    }
    return outcome;
}

ExitCode warp(const WarpOptions& options) {
    return report_st_map(warp_file(options), options.output, options.quiet, options.json);
}

}  // namespace

void add_warp_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, WarpOptions& options) {
        app::Options<WarpOptions> all{
            {option({.name = "PHOTO",
                     .placeholder = "FILE",
                     .meaning = "image: PNG, JPEG, WebP, TIFF, OpenEXR, Radiance HDR, TGA or BMP",
                     .required = true},
                    text(OptionType::file), &WarpOptions::photo)}};
        all.add(&WarpOptions::view,
                {{option({.name = "--camera",
                          .letter = "-c",
                          .placeholder = "FILE[:NAME]",
                          .meaning = "camera of the new picture: its file and the NAME of a camera "
                                     "in it (default: the last), or a built-in camera",
                          .required = true},
                         text(OptionType::camera), &PhotoRequest::camera)}});
        all.rows.push_back(output_option(&WarpOptions::output,
                                         "output file: .png, .jpg, .webp, .tif, or .exr", true));
        all.add(&WarpOptions::view, photo_options());
        all.add({{quiet_flag(&WarpOptions::quiet),
                  json_flag(&WarpOptions::json, "print facts and diagnostics as JSON")}});
        command.add(std::move(all), options);
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
