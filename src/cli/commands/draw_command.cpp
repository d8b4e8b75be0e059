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

#include "balcony/display_file.hpp"
#include "balcony/drawing.hpp"
#include "balcony/inputs.hpp"
#include "balcony/lang.hpp"
#include "balcony/output_file.hpp"
#include "balcony/scene.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/command_rows.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

struct DrawOptions {
    std::string camera;
    std::string output;
    std::vector<std::string> set;
    analyse::Depiction depiction;
    std::array<double, 2> direction{-50.0, 25.0};  ///< Azimuth and elevation in degrees.
    analyse::DrawingView view;                     ///< From there, in the size.
    std::optional<Imath::Color3f> color;
    PictureSize size;
    Manner manner;
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

enum class Format { svg, picture, glb };

std::optional<Format> format_of(const fs::path& file) {
    const std::string ending = ending_of(file);
    return ending == ".svg"                          ? std::optional(Format::svg)
           : ending == ".glb"                        ? std::optional(Format::glb)
           : render::display_format(file) != nullptr ? std::optional(Format::picture)
                                                     : std::nullopt;
}

void check_drawing(DrawOptions& options, const app::GivenWords&, Diagnostics& found) {
    constexpr std::size_t minimum = 16;
    constexpr std::size_t maximum = 16384;
    constexpr std::array<std::size_t, 2> standard{960, 720};
    const auto [width, height] = options.size.resolve(4.0 / 3.0, standard);
    constexpr double radians = std::numbers::pi / 180.0;
    options.view = {options.direction[0] * radians, options.direction[1] * radians, width, height};
    if (std::min(width, height) < minimum || std::max(width, height) > maximum) {
        found.push_back(error(Kind::usage,
                              fmt::format("a drawing cannot have {} x {} pixels", width, height),
                              fmt::format("give a size such as 960x720; a side has {} to {} pixels",
                                          minimum, maximum)));
    } else if (!format_of(options.output)) {
        found.push_back(
            error(Kind::usage,
                  fmt::format("the file extension of '{}' is not a drawing format", options.output),
                  "use a file name that ends in .svg, .png, .jpg, .webp, .tif or .glb"));
    }
}

// What a signal may end; not so the writing of a file.
template <class Work>
auto stoppable(const Work& work) {
    const Job job;
    return work(job.token());
}

Diagnostics write(const analyse::Drawing& drawing, Format format, const fs::path& file) {
    if (format == Format::svg) {
        return write_whole(file, analyse::to_svg(drawing));
    }
    const Result<Image> image = stoppable(
        [&drawing](const std::stop_token& stop) { return analyse::rasterise(drawing, {}, stop); });
    return image ? render::write_samples(image->samples, {image->width, image->height, 3}, file)
                 : image.diagnostics;
}

void write(const camera::Picture& picture, const DrawOptions& options, Answer& answer) {
    analyse::Depiction depiction = options.depiction;
    if (options.color) {
        depiction.color = drawing_color(*options.color);
    }
    const Format format = *format_of(options.output);
    if (format == Format::glb) {
        const auto scene = stoppable([&](const std::stop_token& stop) {
            return analyse::model(picture, depiction, {}, stop);
        });
        if (answer.add(scene.diagnostics)) {
            answer.add(write_whole(options.output, scene::to_glb(*scene)));
        }
    } else {
        const auto drawing = stoppable([&](const std::stop_token& stop) {
            return analyse::draw(picture, depiction, options.view, {}, stop);
        });
        if (answer.add(drawing.diagnostics)) {
            answer.add(write(*drawing, format, options.output));
        }
    }
}

ExitCode draw(const DrawOptions& options) {
    Answer answer;
    answer.facts["output"] = nullptr;
    if (answer.add(OutputFile::check(options.output))) {
        lang::Workspace workspace;
        const auto picture = load_picture(options.camera, options.set, workspace);
        if (answer.add(picture.diagnostics) &&
            answer.add(app::check_overwrites(options.output, workspace.files()))) {
            write(*picture, options, answer);
        }
    }
    if (answer.is_done()) {
        answer.facts["output"] = options.output;
        answer.text = fmt::format("{}: drawn\n", printable(options.output));
    }
    return give(answer, options.manner);
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
        all.add(manner_options(&DrawOptions::manner, "print file name and diagnostics as JSON"));
        all.checks.emplace_back(check_drawing);
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
