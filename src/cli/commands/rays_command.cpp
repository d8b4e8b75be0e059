// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <filesystem>
#include <limits>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "balcony/output_file.hpp"
#include "balcony/ray_maps.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/command_rows.hpp"

namespace balcony::cli {

namespace {

using bridge::NumberFormat;

struct RaysOptions {
    std::string camera;
    std::string output;
    std::optional<NumberFormat> format;
    std::vector<std::string> set;
    SizeRequest size;
    double time = 0.0;
    std::optional<Axes> axes;
    std::string layer;
    bool footprints = false;
    Manner manner;

    [[nodiscard]] bool to_file() const { return !output.empty() && output != "-"; }
};

constexpr std::array formats{Named{NumberFormat::text, "text"},
                             Named{NumberFormat::single_precision, "float"},
                             Named{NumberFormat::double_precision, "double"}};

// EXR files have floats, arrays double precision unless asked otherwise, streams text.
void choose_format(RaysOptions& options, const app::GivenWords&, Diagnostics& found) {
    const std::string ending = ending_of(options.output);
    const bool exr = options.to_file() && ending == ".exr";
    const NumberFormat standard = exr                 ? NumberFormat::single_precision
                                  : options.to_file() ? NumberFormat::double_precision
                                                      : NumberFormat::text;
    const NumberFormat format = options.format.value_or(standard);
    const std::string_view word = Names<NumberFormat>(formats)[format].name;
    options.format = format;
    if (exr && format != NumberFormat::single_precision) {
        found.push_back(app::refused(
            "--format", word,
            "EXR files have float numbers; a file that ends in .npy can have double ones"));
    } else if (options.to_file() && format == NumberFormat::text) {
        found.push_back(
            app::refused("--format", word, "text is for standard output: leave out --output"));
    } else if (options.to_file() && !exr && ending != ".npy") {
        found.push_back(error(
            Kind::usage,
            fmt::format("the file extension of '{}' is not that of a ray map", options.output),
            "use a file name that ends in .exr or .npy, or omit --output for a stream"));
    } else if (!options.to_file() && options.manner.json) {
        found.push_back(error(Kind::usage, "--json and rays on standard output exclude each other",
                              "name a file with --output"));
    } else if (!options.to_file() && options.footprints) {
        found.push_back(error(Kind::usage,
                              "a stream has no footprints: it has six numbers for each ray",
                              "name a file that ends in .exr or .npy with --output"));
    }
}

bridge::RaysWritten write(const RaysOptions& options, const bridge::RayGrid& grid,
                          const std::stop_token& stop) {
    if (options.to_file()) {
        return write_ray_map(grid, options.output, *options.format, stop);
    }
    bridge::RaysWritten written = stream_rays(
        grid, *options.format,
        [](std::span<const char> bytes) {
            return print_bytes({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
        },
        stop);
    if (!written.complete && !stop.stop_requested()) {
        written.problems.push_back(error(
            Kind::environment,
            fmt::format("standard output took only {} of {} rays", written.rays, grid.size())));
    }
    return written;
}

void write_rays(const RaysOptions& options, const bridge::RayGrid& grid, Answer& answer) {
    const Interruptible work;
    const bridge::RaysWritten written = write(options, grid, work.token());
    answer.interrupted = !written.complete && work.token().stop_requested();
    if (answer.interrupted || !answer.add(written.problems)) {
        return;
    }
    answer.facts.update({{"output", options.output},
                         {"camera", grid.name()},
                         {"axes", grid.axes() == Axes::y_up ? "y_up" : "z_up"},
                         {"width", grid.width()},
                         {"height", grid.height()},
                         {"valid", written.valid},
                         {"columns", nlohmann::json::array()}});
    for (const bridge::RayColumn& column : ray_columns(grid)) {
        answer.facts["columns"].push_back(column.name);
    }
    if (options.to_file()) {
        answer.text = fmt::format("{}: {} x {} pixels, {} with a ray\n", printable(options.output),
                                  grid.width(), grid.height(), written.valid);
    }
}

void make_rays(const RaysOptions& options, Answer& answer) {
    if (options.to_file() && !answer.add(OutputFile::check(options.output))) {
        return;
    }
    lang::Workspace workspace;
    const auto picture = load_picture(options.camera, options.set, workspace);
    if (!answer.add(picture.diagnostics) ||
        (options.to_file() &&
         !answer.add(app::check_overwrites(options.output, workspace.files())))) {
        return;
    }
    bridge::RaySettings settings{.layer = options.layer,
                                 .axes = options.axes,
                                 .time = options.time,
                                 .footprints = options.footprints};
    std::tie(settings.width, settings.height) =
        options.size.resolve(picture->aspect(), picture->parts().size);
    const auto grid = bridge::RayGrid::make(picture->with_fit(options.size.fit), settings);
    if (answer.add(grid.diagnostics)) {
        write_rays(options, *grid, answer);
    }
}

ExitCode rays(const RaysOptions& options) {
    Answer answer;
    answer.facts["output"] = nullptr;
    make_rays(options, answer);
    return give(answer, options.manner);
}

}  // namespace

void add_rays_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, RaysOptions& options) {
        app::Options<RaysOptions> all{
            {camera_argument(&RaysOptions::camera),
             output_option(&RaysOptions::output,
                           "ray map: .exr, or .npy for NumPy (default: a stream of rays on "
                           "standard output, as Radiance's rtrace reads it)"),
             option({.name = "--format",
                     .placeholder = "FORMAT",
                     .meaning = "numbers of the stream: text, float or double (default: text); of "
                                "a .npy file: float or double (default: double)"},
                    app::maybe(app::choice(Names<NumberFormat>(formats))), &RaysOptions::format),
             layer_option(&RaysOptions::layer),
             flag({.name = "--footprints",
                   .meaning = "add the derivatives of each ray by the picture's x and y to a ray "
                              "map"},
                  true, &RaysOptions::footprints),
             app::set_option(&RaysOptions::set)},
            {choose_format}};
        all.add(&RaysOptions::size, app::size_options("size of the picture in pixels"));
        all.add(&RaysOptions::size, app::aspect_options());
        all.add({{app::time_option(std::numeric_limits<double>::max(), &RaysOptions::time),
                  axes_option(&RaysOptions::axes,
                              "axes of the rays: y_up or z_up (default: those of the camera)")}});
        all.add(manner_options(&RaysOptions::manner));
        command.add(std::move(all), options);
        command.footer(
            "Examples:\n"
            "  balcony rays panorama -o rays.exr\n"
            "  balcony rays my.cam:closeup --size 1920x1080 --footprints -o rays.npy\n"
            "  balcony rays pinhole --size 64x48 --format text    a stream, for rtrace -fa");
    };
    add_command<RaysOptions>(app, code, "rays",
                             "writes the rays of a camera as data for other programs", rays,
                             describe);
}

}  // namespace balcony::cli
