// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/display_file.hpp"
#include "balcony/drawing.hpp"
#include "balcony/inputs.hpp"
#include "balcony/lang.hpp"
#include "balcony/output_file.hpp"
#include "balcony/scene.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/json.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

struct DrawOptions {
    std::string camera;
    std::string output;
    std::vector<std::string> set;
    analyse::Depiction depiction;
    /// Azimuth and elevation in degrees.
    std::array<double, 2> direction{-50.0, 25.0};
    std::optional<Imath::Color3f> color;
    PictureSize size;
    bool quiet = false;
    bool json = false;
};

struct Outcome {
    ExitCode code = ExitCode::done;
    Diagnostics diagnostics;
};

constexpr double largest = 1e12;

// From a linear colour, as in the options of render, to bytes of sRGB.
analyse::DrawingColor drawing_color(const Imath::Color3f& color) {
    const auto byte = [](float level) {
        constexpr float straight = 0.0031308F;
        const float encoded =
            level <= straight ? 12.92F * level : 1.055F * std::pow(level, 1.0F / 2.4F) - 0.055F;
        return static_cast<std::uint8_t>(std::lround(255.0F * encoded));
    };
    return {byte(color.x), byte(color.y), byte(color.z)};
}

app::Value<std::array<double, 2>> direction_value() {
    app::Value<std::array<double, 2>> made;
    made.info.unit = "deg";
    made.read = [](std::string_view word) -> std::optional<std::array<double, 2>> {
        const std::size_t comma = std::min(word.find(','), word.size());
        const auto azimuth = app::number_of<double>(word.substr(0, comma));
        const auto elevation =
            app::number_of<double>(word.substr(std::min(comma + 1, word.size())));
        return azimuth && elevation && std::abs(*azimuth) <= 360.0 && std::abs(*elevation) <= 90.0
                   ? std::optional(std::array{*azimuth, *elevation})
                   : std::nullopt;
    };
    made.write = [](const std::array<double, 2>& angles) {
        return fmt::format("{},{}", angles[0], angles[1]);
    };
    made.remedy = [](std::string_view) {
        return "give two angles in degrees, azimuth from x to the left and elevation, such as "
               "-50,25";
    };
    return made;
}

app::Options<DrawOptions> arrow_options() {
    using analyse::Depiction;
    const auto part = [](const char* name, const char* meaning, bool Depiction::*shown) {
        return flag({.name = name, .meaning = meaning}, false, &DrawOptions::depiction, shown);
    };
    return {{option({.name = "--rays",
                     .placeholder = "COUNT",
                     .meaning = "number of arrows along the longer side of the camera's picture"},
                    app::count(0, 100), &DrawOptions::depiction, &Depiction::rays),
             option({.name = "--length",
                     .placeholder = "LENGTH",
                     .meaning = "length of the arrows in scene units"},
                    app::or_word("auto", app::number(1e-12, largest,
                                                     "give auto, or a length above 0 in scene "
                                                     "units",
                                                     "scene units")),
                    &DrawOptions::depiction, &Depiction::length),
             option({.name = "--color",
                     .placeholder = "COLOUR",
                     .meaning = "colour of the arrows: a grey level, or red,green,blue (linear, "
                                "from 0 to 1)"},
                    app::or_word("auto", app::color(1.0F,
                                                    "give auto, a grey level such as 0.2, or "
                                                    "red,green,blue, each from 0 to 1")),
                    &DrawOptions::color),
             part("--no-eye", "omit the eye object", &Depiction::eye),
             part("--no-toward", "omit the direction object", &Depiction::toward),
             part("--no-frame", "omit the picture's border", &Depiction::frame),
             part("--no-axes", "omit the axes", &Depiction::axes)}};
}

analyse::DrawingView read_view(const DrawOptions& options, Diagnostics& diagnostics) {
    analyse::DrawingView view;
    constexpr double radians = std::numbers::pi / 180.0;
    view.azimuth = options.direction[0] * radians;
    view.elevation = options.direction[1] * radians;
    constexpr std::size_t minimum = 16;
    constexpr std::size_t maximum = 16384;
    constexpr std::array<std::size_t, 2> standard{960, 720};
    const auto [width, height] = options.size.resolve(4.0 / 3.0, standard);
    if (std::min(width, height) >= minimum && std::max(width, height) <= maximum) {
        view.width = width;
        view.height = height;
    } else {
        diagnostics.push_back(
            error(fmt::format("a drawing cannot have {} x {} pixels", width, height), {},
                  fmt::format("give a size such as 960x720; a side has {} to {} pixels", minimum,
                              maximum)));
    }
    return view;
}

enum class Format { svg, picture, glb };

std::optional<Format> format_of(const fs::path& file) {
    const std::string ending = ending_of(file);
    return ending == ".svg"                          ? std::optional(Format::svg)
           : ending == ".glb"                        ? std::optional(Format::glb)
           : render::display_format(file) != nullptr ? std::optional(Format::picture)
                                                     : std::nullopt;
}

ExitCode check_output(const fs::path& file, Diagnostics& diagnostics) {
    if (!format_of(file)) {
        diagnostics.push_back(
            error(fmt::format("the file extension of '{}' is not a drawing format", file.string()),
                  {}, "use a file name that ends in .svg, .png, .jpg, .webp, .tif or .glb"));
        return ExitCode::wrong_usage;
    }
    const Diagnostics found = OutputFile::check(file);
    diagnostics.insert(diagnostics.end(), found.begin(), found.end());
    return has_errors(found) ? ExitCode::environment : ExitCode::done;
}

Diagnostics write_drawing(const analyse::Drawing& drawing, Format format, const fs::path& file) {
    if (format == Format::svg) {
        return write_whole(file, analyse::to_svg(drawing));
    }
    std::optional<Job> job(std::in_place);
    const Result<Image> image = analyse::rasterise(drawing, {}, job->token());
    job.reset();
    return image ? render::write_samples(image->samples, {image->width, image->height, 3}, file)
                 : image.diagnostics;
}

// An error of the camera is in the first value, an error of writing in the second.
struct Written {
    Diagnostics camera, file;
};

Written write(const camera::Picture& picture, const analyse::Depiction& depiction,
              const analyse::DrawingView& view, const fs::path& file) {
    const Format format = *format_of(file);
    if (format == Format::glb) {
        std::optional<Job> job(std::in_place);
        const auto scene = analyse::model(picture, depiction, {}, job->token());
        job.reset();
        if (!scene) {
            return {scene.diagnostics, {}};
        }
        return {scene.diagnostics, write_whole(file, scene::to_glb(*scene))};
    }
    std::optional<Job> job(std::in_place);
    const auto drawing = analyse::draw(picture, depiction, view, {}, job->token());
    job.reset();
    return {drawing.diagnostics, drawing ? write_drawing(*drawing, format, file) : Diagnostics{}};
}

Outcome make_drawing(const DrawOptions& options) {
    Outcome outcome;
    const auto add = [&outcome](const Diagnostics& diagnostics, ExitCode code) {
        outcome.diagnostics.insert(outcome.diagnostics.end(), diagnostics.begin(),
                                   diagnostics.end());
        const std::optional<Kind> kind = kind_of_errors(diagnostics);
        outcome.code = kind == Kind::interrupted ? ExitCode::interrupted
                       : kind                    ? code
                                                 : outcome.code;
    };
    Diagnostics usage;
    analyse::Depiction depiction = options.depiction;
    if (options.color) {
        depiction.color = drawing_color(*options.color);
    }
    const analyse::DrawingView view = read_view(options, usage);
    add(usage, ExitCode::wrong_usage);
    if (outcome.code == ExitCode::done) {
        outcome.code = check_output(options.output, outcome.diagnostics);
    }
    if (outcome.code != ExitCode::done) {
        return outcome;
    }
    lang::Workspace workspace;
    const auto picture = load_picture(options.camera, options.set, workspace);
    add(picture.diagnostics, ExitCode::bad_input);
    add(app::check_overwrites(options.output, workspace.files()), ExitCode::wrong_usage);
    if (outcome.code == ExitCode::done) {
        const Written written = write(*picture, depiction, view, options.output);
        add(written.camera, ExitCode::bad_input);
        add(written.file, ExitCode::environment);
    }
    return outcome;
}

ExitCode draw(const DrawOptions& options) {
    const Outcome outcome = make_drawing(options);
    const bool done = outcome.code == ExitCode::done;
    if (options.json) {
        nlohmann::json facts{{"diagnostics", to_json(outcome.diagnostics)}, {"output", nullptr}};
        if (done) {
            facts["output"] = options.output;
        }
        print_json(facts);
        return outcome.code;
    }
    report(outcome.diagnostics);
    if (done && !options.quiet) {
        print_result(fmt::format("{}: drawn\n", printable(options.output)));
    }
    return outcome.code;
}

}  // namespace

void add_draw_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, DrawOptions& options) {
        app::Options<DrawOptions> all{
            {camera_argument(&DrawOptions::camera),
             output_option(
                 &DrawOptions::output,
                 "output file: a picture (.svg, .png, .jpg, .webp, .tif) or a scene (.glb)", true),
             app::set_option(&DrawOptions::set),
             app::time_option(largest, &DrawOptions::depiction, &analyse::Depiction::time),
             option({.name = "--view",
                     .placeholder = "AZIMUTH,ELEVATION",
                     .meaning = "direction of the viewer in degrees: around z from x, and above "
                                "the horizon"},
                    direction_value(), &DrawOptions::direction)}};
        all.add(&DrawOptions::size,
                app::size_options("size of a drawing in pixels (default: 960x720)"));
        all.add(arrow_options());
        all.add({{quiet_flag(&DrawOptions::quiet),
                  json_flag(&DrawOptions::json, "print file name and diagnostics as JSON")}});
        command.add(std::move(all), options);
        command.footer(
            "Examples:\n"
            "  balcony draw superelliptic -o superelliptic.svg\n"
            "  balcony draw my.cam:closeup --view 120,10 --size 1600x1200 -o closeup.png\n"
            "  balcony draw my.cam:poster -o poster.svg\n"
            "  balcony draw my.cam --rays 20 --length 2 -o camera.glb");
    };
    add_command<DrawOptions>(app, code, "draw",
                             "draws a camera, or the cameras of a picture, with their rays", draw,
                             describe);
}

}  // namespace balcony::cli
