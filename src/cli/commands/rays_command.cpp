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
#include "cli/options/common_options.hpp"
#include "cli/options/option_values.hpp"
#include "cli/report/json.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

using bridge::NumberFormat;

struct RaysOptions {
    std::string camera;
    std::string output;
    std::string format;
    std::vector<std::string> set;
    SizeWords size;
    std::string time = "0";
    std::string axes;
    std::string layer;
    bool footprints = false;
    bool quiet = false;
    bool json = false;

    [[nodiscard]] bool to_file() const { return !output.empty() && output != "-"; }
};

// What is asked for, apart from the camera.
struct RaysRequest {
    PictureSize size;
    NumberFormat format = NumberFormat::text;
    bridge::RaySettings settings{};
};

constexpr std::array formats{std::pair{"text", NumberFormat::text},
                             std::pair{"float", NumberFormat::single_precision},
                             std::pair{"double", NumberFormat::double_precision}};

// EXR files have floats, arrays double precision unless asked otherwise, streams text.
NumberFormat read_format(const RaysOptions& options, Diagnostics& diagnostics) {
    const std::string ending = ending_of(options.output);
    const bool exr = options.to_file() && ending == ".exr";
    if (options.format.empty()) {
        return exr                 ? NumberFormat::single_precision
               : options.to_file() ? NumberFormat::double_precision
                                   : NumberFormat::text;
    }
    check_name("--format", options.format, {"text", "float", "double"}, diagnostics);
    NumberFormat format = NumberFormat::text;
    for (const auto& [name, value] : formats) {
        format = options.format == name ? value : format;
    }
    if (exr && format != NumberFormat::single_precision) {
        refuse(diagnostics, "--format", options.format,
               "EXR files have float numbers; a file that ends in .npy can have double ones");
    } else if (options.to_file() && format == NumberFormat::text) {
        refuse(diagnostics, "--format", options.format,
               "text is for standard output: leave out --output");
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

RaysRequest read_rays_request(const RaysOptions& options, Diagnostics& diagnostics) {
    constexpr double any = std::numeric_limits<double>::max();
    RaysRequest request{.size = read_size(options.size, diagnostics),
                        .format = read_format(options, diagnostics)};
    request.settings = {
        .layer = options.layer,
        .axes = read_axes(options.axes, diagnostics),
        .time = read_number("--time", options.time, -any, any, "give a number", diagnostics),
        .footprints = options.footprints};
    return request;
}

Result<bridge::RayGrid> make_grid(const RaysOptions& options, RaysRequest request) {
    auto picture = load_picture(options.camera, options.set);
    if (!picture) {
        return std::move(picture.diagnostics);
    }
    std::tie(request.settings.width, request.settings.height) =
        request.size.resolve(picture->aspect(), picture->parts().size);
    auto grid = bridge::RayGrid::make(picture->with_fit(request.size.fit), request.settings);
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
    const RaysRequest request = read_rays_request(options, outcome.diagnostics);
    outcome.code = outcome.diagnostics.empty() ? check_rays_output(options, outcome.diagnostics)
                                               : ExitCode::wrong_usage;
    if (outcome.code != ExitCode::done) {
        return outcome;
    }
    auto grid = make_grid(options, request);
    outcome.diagnostics = std::move(grid.diagnostics);
    outcome.grid = std::move(grid.value);
    if (outcome.grid) {
        write_rays(options, request.format, outcome);
    } else {
        outcome.code = ExitCode::bad_input;
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
    const auto describe = [](CLI::App& command, RaysOptions& options) {
        add_camera_option(command, options.camera);
        command
            .add_option("-o,--output", options.output,
                        "ray map: .exr, or .npy for NumPy (default: a stream of rays on standard "
                        "output, as Radiance's rtrace reads it)")
            ->type_name("FILE");
        command
            .add_option("--format", options.format,
                        "numbers of the stream: text, float or double (default: text); of a .npy "
                        "file: float or double (default: double)")
            ->type_name("FORMAT");
        command
            .add_option("--layer", options.layer,
                        "the camera layer of a picture: its name or its number, counted from 1 at "
                        "the back")
            ->type_name("LAYER");
        command.add_flag("--footprints", options.footprints,
                         "add the derivatives of each ray by the picture's x and y to a ray map");
        add_set_option(command, options.set);
        add_size_options(command, options.size, "size of the picture in pixels");
        add_aspect_option(command, options.size);
        add_time_option(command, options.time);
        command
            .add_option("--axes", options.axes,
                        "axes of the rays: y_up or z_up (default: those of the camera)")
            ->type_name("AXES");
        add_quiet_option(command, options.quiet);
        command.add_flag("--json", options.json, "print facts and diagnostics as JSON");
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
