// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <filesystem>

#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/options/photo_options.hpp"
#include "cli/report/st_map_report.hpp"

namespace balcony::cli {

namespace {

struct StMapOptions {
    PhotoRequest photo;
    SizeRequest photo_size;
    std::string output;
    Manner manner;
};

void check_st_map(StMapOptions& options, const app::GivenWords&, Diagnostics& found) {
    // Both sides, or what follows from the aspect of the photo's camera.
    if (options.photo_size.width && !options.photo_size.height) {
        found.push_back(error(Kind::usage, "--from-size needs both sides of the photo",
                              "write --from-size 4096x2048"));
    }
}

void make_st_map_file(const StMapOptions& options, Answer& answer) {
    if (!answer.add(bridge::check_st_map_file(options.output))) {
        return;
    }
    const SizeRequest& size = options.photo_size;
    const auto photo_size =
        size.width ? std::optional(std::array{*size.width, *size.height}) : std::nullopt;
    lang::Workspace workspace;
    const auto map = make_st_map(options.photo, photo_size, workspace);
    if (answer.add(map.diagnostics) &&
        answer.add(app::check_overwrites(options.output, workspace.files()))) {
        const Interruptible work;
        add_written(answer, *map, write_st_map(*map, options.output, work.token()), options.output);
    }
}

ExitCode stmap(const StMapOptions& options) {
    Answer answer;
    answer.facts["output"] = nullptr;
    make_st_map_file(options, answer);
    return give(answer, options.manner);
}

}  // namespace

void add_stmap_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, StMapOptions& options) {
        app::Options<StMapOptions> all;
        all.add(&StMapOptions::photo, {{camera_argument(&PhotoRequest::camera)}});
        all.rows.push_back(output_option(
            &StMapOptions::output,
            "EXR file: red and green are the position in the photo, alpha is 1 where the photo "
            "shows the pixel",
            true));
        all.add(&StMapOptions::photo, photo_options_of_layers());
        all.add(&StMapOptions::photo_size,
                {{app::size_option(
                    {.name = "--from-size",
                     .placeholder = "WIDTHxHEIGHT",
                     .meaning = "size of the photo in pixels, if its aspect ratio is not that of "
                                "its camera"})}});
        all.add(manner_options(&StMapOptions::manner));
        all.checks.emplace_back(check_st_map);
        command.add(std::move(all), options);
        command.footer(
            "Examples:\n"
            "  balcony stmap fisheye --from panorama --size 1024 -o st.exr\n"
            "  balcony stmap pinhole --from fisheye --from-set fov=200deg -o st.exr");
    };
    add_command<StMapOptions>(app, code, "stmap",
                              "writes the map that warps a photo into the picture of a camera",
                              stmap, describe);
}

}  // namespace balcony::cli
