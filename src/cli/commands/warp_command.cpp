// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <filesystem>
#include <vector>

#include <fmt/format.h>

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
    std::optional<double> dpi;
    Manner manner;
};

void warp_file(const WarpOptions& options, Answer& answer) {
    if (!answer.add(render::check_output(options.output)) ||
        !answer.add(app::check_dpi(options.dpi, options.output))) {
        return;
    }
    const auto photo = bridge::Photo::load(options.photo);
    if (!answer.add(photo.diagnostics)) {
        return;
    }
    lang::Workspace workspace;
    const auto map =
        make_st_map(options.view, std::array{photo->width(), photo->height()}, workspace);
    std::vector<fs::path> inputs = workspace.files();
    inputs.emplace_back(options.photo);
    if (answer.add(map.diagnostics) && answer.add(app::check_overwrites(options.output, inputs))) {
        const Interruptible work;
        add_written(
            answer, *map,
            warp_photo(*map, *photo, options.output, options.dpi.value_or(0.0), work.token()),
            options.output);
    }
}

ExitCode warp(const WarpOptions& options) {
    Answer answer;
    answer.facts["output"] = nullptr;
    warp_file(options, answer);
    return give(answer, options.manner);
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
        all.add(&WarpOptions::view, photo_options_of_layers());
        all.rows.push_back(app::dpi_option(&WarpOptions::dpi));
        all.add(manner_options(&WarpOptions::manner));
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
