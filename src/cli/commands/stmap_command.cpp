// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <filesystem>

#include <fmt/format.h>

#include "balcony/output_file.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/options/photo_options.hpp"
#include "cli/report/st_map_report.hpp"

namespace balcony::cli {

namespace {

struct StMapOptions {
    PhotoRequest photo;
    PictureSize photo_size;
    std::string output;
    bool quiet = false;
    bool json = false;
};

ExitCode check_st_map_output(const StMapOptions& options, Diagnostics& diagnostics) {
    if (ending_of(options.output) != ".exr") {
        diagnostics.push_back(error(
            fmt::format("'{}' is no name for an STMap, whose numbers need floats", options.output),
            {}, "use a file name that ends in .exr"));
        return ExitCode::wrong_usage;
    }
    const Diagnostics found = OutputFile::check(options.output);
    diagnostics.insert(diagnostics.end(), found.begin(), found.end());
    return has_errors(found) ? ExitCode::environment : ExitCode::done;
}

// Both sides, or what follows from the aspect of the photo's camera.
void check_photo_size(StMapOptions& options, const app::GivenWords&, Diagnostics& diagnostics) {
    if (options.photo_size.width && !options.photo_size.height) {
        diagnostics.push_back(
            error("--from-size needs both sides of the photo", {}, "write --from-size 4096x2048"));
    }
}

StMapOutcome make_st_map_file(const StMapOptions& options) {
    StMapOutcome outcome;
    outcome.code = check_st_map_output(options, outcome.diagnostics);
    if (outcome.code != ExitCode::done) {
        return outcome;
    }
    const PictureSize& size = options.photo_size;
    lang::Workspace workspace;
    const auto photo_size =
        size.width ? std::optional(std::array{*size.width, *size.height}) : std::nullopt;
    auto map = make_st_map(options.photo, photo_size, workspace);
    outcome.add(map.diagnostics, ExitCode::bad_input);
    outcome.map = std::move(map.value);
    outcome.add(app::check_overwrites(options.output, workspace.files()), ExitCode::wrong_usage);
    if (outcome.code == ExitCode::done) {
        const Job job;
        outcome.add(write_st_map(*outcome.map, options.output, job.token()));
    }
    return outcome;
}

ExitCode stmap(const StMapOptions& options) {
    return report_st_map(make_st_map_file(options), options.output, options.quiet, options.json);
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
        all.add(&StMapOptions::photo, photo_options());
        all.add(&StMapOptions::photo_size,
                {{app::size_option(
                    {.name = "--from-size",
                     .placeholder = "WIDTHxHEIGHT",
                     .meaning = "size of the photo in pixels, if its aspect ratio is not that of "
                                "its camera"})}});
        all.add({{quiet_flag(&StMapOptions::quiet),
                  json_flag(&StMapOptions::json, "print facts and diagnostics as JSON")},
                 {check_photo_size}});
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
