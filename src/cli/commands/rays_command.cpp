// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <filesystem>
#include <limits>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/output_file.hpp"
#include "balcony/ray_maps.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/json.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

using bridge::NumberFormat;

struct RaysOptions {
    std::string camera;
    std::string output;
    std::optional<NumberFormat> format;
    std::vector<std::string> set;
    PictureSize size;
    double time = 0.0;
    std::optional<Axes> axes;
    std::string layer;
    bool footprints = false;
    bool quiet = false;
    bool json = false;

    [[nodiscard]] bool to_file() const { return !output.empty() && output != "-"; }
};

constexpr std::array formats{Named{NumberFormat::text, "text"},
                             Named{NumberFormat::single_precision, "float"},
                             Named{NumberFormat::double_precision, "double"}};

// EXR files have floats, arrays double precision unless asked otherwise, streams text.
NumberFormat chosen_format(const RaysOptions& options, Diagnostics& diagnostics) {
    const std::string ending = ending_of(options.output);
    const bool exr = options.to_file() && ending == ".exr";
    if (!options.format) {
        return exr                 ? NumberFormat::single_precision
               : options.to_file() ? NumberFormat::double_precision
                                   : NumberFormat::text;
    }
    const NumberFormat format = *options.format;
    const Names<NumberFormat> names(formats);
    const std::string_view word = names[format].name;
    if (exr && format != NumberFormat::single_precision) {
        diagnostics.push_back(app::refused(
            "--format", word,
            "EXR files have float numbers; a file that ends in .npy can have double ones"));
    } else if (options.to_file() && format == NumberFormat::text) {
        diagnostics.push_back(
            app::refused("--format", word, "text is for standard output: leave out --output"));
    }
    return format;
}

ExitCode check_rays_output(const RaysOptions& options, Diagnostics& diagnostics) {
    if (!options.to_file()) {
        if (options.json) {
            diagnostics.push_back(error("--json and rays on standard output exclude each other", {},
                                        "name a file with --output"));
        } else if (options.footprints) {
            diagnostics.push_back(
                error("a stream has no footprints: it has six numbers for each ray", {},
                      "name a file that ends in .exr or .npy with --output"));
        }
        return diagnostics.empty() ? ExitCode::done : ExitCode::wrong_usage;
    }
    const std::filesystem::path file = options.output;
    if (ending_of(file) != ".exr" && ending_of(file) != ".npy") {
        diagnostics.push_back(error(
            fmt::format("the file extension of '{}' is not that of a ray map", options.output), {},
            "use a file name that ends in .exr or .npy, or omit --output for a stream"));
        return ExitCode::wrong_usage;
    }
    const Diagnostics found = OutputFile::check(file);
    diagnostics.insert(diagnostics.end(), found.begin(), found.end());
    return has_errors(found) ? ExitCode::environment : ExitCode::done;
}

Result<bridge::RayGrid> make_grid(const RaysOptions& options) {
    lang::Workspace workspace;
    auto picture = load_picture(options.camera, options.set, workspace);
    if (!picture) {
        return std::move(picture.diagnostics);
    }
    if (options.to_file()) {
        Diagnostics found = app::check_overwrites(options.output, workspace.files());
        if (has_errors(found)) {
            return found;
        }
    }
    bridge::RaySettings settings{.layer = options.layer,
                                 .axes = options.axes,
                                 .time = options.time,
                                 .footprints = options.footprints};
    std::tie(settings.width, settings.height) =
        options.size.resolve(picture->aspect(), picture->parts().size);
    auto grid = bridge::RayGrid::make(picture->with_fit(options.size.fit), settings);
    grid.diagnostics.insert(grid.diagnostics.begin(), picture.diagnostics.begin(),
                            picture.diagnostics.end());
    return grid;
}

// What came of it.
struct RaysOutcome {
    ExitCode code = ExitCode::done;
    Diagnostics diagnostics{};
    std::optional<bridge::RayGrid> grid{};
    bridge::RaysWritten written{};
};

void write_rays(const RaysOptions& options, NumberFormat format, RaysOutcome& outcome) {
    const Job job;
    const auto to_output = [](std::span<const char> bytes) {
        return print_bytes({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    };
    outcome.written = options.to_file()
                          ? write_ray_map(*outcome.grid, options.output, format, job.token())
                          : stream_rays(*outcome.grid, format, to_output, job.token());
    Diagnostics& found = outcome.written.problems;
    if (outcome.written.complete && found.empty()) {
        return;
    }
    if (job.token().stop_requested()) {
        outcome.code = ExitCode::interrupted;
        return;
    }
    outcome.code = ExitCode::environment;
    if (!options.to_file()) {
        found.push_back(error(fmt::format("standard output took only {} of {} rays",
                                          outcome.written.rays, outcome.grid->size())));
    }
    outcome.diagnostics.insert(outcome.diagnostics.end(), found.begin(), found.end());
}

RaysOutcome make_rays(const RaysOptions& options) {
    RaysOutcome outcome;
    const NumberFormat format = chosen_format(options, outcome.diagnostics);
    outcome.code = outcome.diagnostics.empty() ? check_rays_output(options, outcome.diagnostics)
                                               : ExitCode::wrong_usage;
    if (outcome.code != ExitCode::done) {
        return outcome;
    }
    auto grid = make_grid(options);
    outcome.diagnostics = std::move(grid.diagnostics);
    outcome.grid = std::move(grid.value);
    if (outcome.grid) {
        write_rays(options, format, outcome);
    } else {
        outcome.code = exit_code_of(outcome.diagnostics);
    }
    return outcome;
}

nlohmann::json json_of(const RaysOutcome& outcome, const RaysOptions& options) {
    nlohmann::json document{{"output", nullptr}, {"diagnostics", to_json(outcome.diagnostics)}};
    if (outcome.code == ExitCode::done) {
        document["output"] = options.output;
        document["camera"] = outcome.grid->name();
        document["axes"] = outcome.grid->axes() == Axes::y_up ? "y_up" : "z_up";
        document["width"] = outcome.grid->width();
        document["height"] = outcome.grid->height();
        document["valid"] = outcome.written.valid;
        document["columns"] = nlohmann::json::array();
        for (const bridge::RayColumn& column : ray_columns(*outcome.grid)) {
            document["columns"].push_back(column.name);
        }
    }
    return document;
}

ExitCode rays(const RaysOptions& options) {
    const RaysOutcome outcome = make_rays(options);
    if (options.json) {
        print_json(json_of(outcome, options));
        return outcome.code;
    }
    report(outcome.diagnostics);
    if (outcome.code == ExitCode::done && options.to_file() && !options.quiet) {
        print_result(fmt::format("{}: {} x {} pixels, {} with a ray\n", printable(options.output),
                                 outcome.grid->width(), outcome.grid->height(),
                                 outcome.written.valid));
    }
    return outcome.code;
}

}  // namespace

void add_rays_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, RaysOptions& options) {
        command.add<RaysOptions>(
            {{camera_argument(&RaysOptions::camera),
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
              app::set_option(&RaysOptions::set)}},
            options);
        app::Options<RaysOptions> picture;
        picture.add(&RaysOptions::size, app::size_options("size of the picture in pixels"));
        picture.add(&RaysOptions::size, app::aspect_options());
        picture.add({{app::time_option(std::numeric_limits<double>::max(), &RaysOptions::time),
                      axes_option(&RaysOptions::axes,
                                  "axes of the rays: y_up or z_up (default: those of the camera)"),
                      quiet_flag(&RaysOptions::quiet),
                      json_flag(&RaysOptions::json, "print facts and diagnostics as JSON")}});
        command.add(std::move(picture), options);
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
