// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <filesystem>

#include <fmt/format.h>

#include "balcony/output_file.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/options/photo_options.hpp"
#include "cli/report/st_map_report.hpp"

namespace balcony::cli {

namespace {

struct StMapOptions {
    PhotoOptions photo;
    SizeWords photo_size;
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
std::optional<std::array<std::size_t, 2>> read_photo_size(const SizeWords& words,
                                                          Diagnostics& diagnostics) {
    const PictureSize size = read_size(words, diagnostics);
    if (size.width && !size.height) {
        diagnostics.push_back(
            error("--from-size needs both sides of the photo", {}, "write --from-size 4096x2048"));
    }
    return size.width && size.height ? std::optional(std::array{*size.width, *size.height})
                                     : std::nullopt;
}

StMapOutcome make_st_map_file(const StMapOptions& options) {
    StMapOutcome outcome;
    const PhotoRequest request = read_photo_request(options.photo, outcome.diagnostics);
    const auto photo_size = read_photo_size(options.photo_size, outcome.diagnostics);
    outcome.code = outcome.diagnostics.empty() ? check_st_map_output(options, outcome.diagnostics)
                                               : ExitCode::wrong_usage;
    if (outcome.code != ExitCode::done) {
        return outcome;
    }
    auto map = make_st_map(options.photo, request, photo_size);
    outcome.add(map.diagnostics, ExitCode::bad_input);
    outcome.map = std::move(map.value);
    if (outcome.map) {
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
    const auto describe = [](CLI::App& command, StMapOptions& options) {
        add_camera_option(command, options.photo.camera);
        command
            .add_option("-o,--output", options.output,
                        "EXR file: red and green are the position in the photo, alpha is 1 where "
                        "the photo shows the pixel")
            ->type_name("FILE")
            ->required();
        add_photo_options(command, options.photo);
        command
            .add_option("--from-size", options.photo_size.size,
                        "size of the photo in pixels, if its aspect ratio is not that of its "
                        "camera")
            ->type_name("WIDTHxHEIGHT");
        add_quiet_option(command, options.quiet);
        command.add_flag("--json", options.json, "print facts and diagnostics as JSON");
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
