// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "balcony/studies.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/command_rows.hpp"

namespace balcony::cli {

namespace {

struct DrawOptions {
    app::DrawRequest request;  ///< Without its view and its colour.
    std::string output;
    std::array<double, 2> direction{-50.0, 25.0};  ///< Azimuth and elevation in degrees.
    std::optional<Imath::Color3f> color;
    SizeRequest size;
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
        return flag({.name = name, .meaning = meaning}, false, &DrawOptions::request,
                    &app::DrawRequest::depiction, shown);
    };
    return {{option({.name = "--rays",
                     .placeholder = "COUNT",
                     .meaning = "number of arrows along the longer side of the camera's picture"},
                    app::count(0, 100), &DrawOptions::request, &app::DrawRequest::depiction,
                    &Depiction::rays),
             option({.name = "--length",
                     .placeholder = "LENGTH",
                     .meaning = "length of the arrows in scene units"},
                    app::or_word("auto", app::number(1e-12, largest,
                                                     "give auto, or a length above 0 in scene "
                                                     "units",
                                                     "scene units")),
                    &DrawOptions::request, &app::DrawRequest::depiction, &Depiction::length),
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

app::DrawRequest request_of(const DrawOptions& options) {
    constexpr std::array<std::size_t, 2> standard{960, 720};
    constexpr double radians = std::numbers::pi / 180.0;
    const auto [width, height] = options.size.resolve(4.0 / 3.0, standard);
    app::DrawRequest request = options.request;
    request.view = {options.direction[0] * radians, options.direction[1] * radians, width, height};
    if (options.color) {
        request.depiction.color = drawing_color(*options.color);
    }
    request.output = options.output;
    return request;
}

ExitCode draw(const DrawOptions& options) {
    Answer answer;
    answer.facts["output"] = nullptr;
    const Interruptible work;
    if (answer.add(app::draw(request_of(options), work.token()))) {
        answer.facts["output"] = options.output;
        answer.text = fmt::format("{}: drawn\n", printable(options.output));
    }
    return give(answer, options.manner);
}

}  // namespace

void add_draw_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, DrawOptions& options) {
        app::Options<DrawOptions> all;
        all.add(&DrawOptions::request, {{camera_argument(&app::DrawRequest::camera)}});
        all.rows.push_back(output_option(
            &DrawOptions::output,
            "output file: a picture (.svg, .png, .jpg, .webp, .tif) or a scene (.glb)", true));
        all.add(
            &DrawOptions::request,
            {{app::set_option(&app::DrawRequest::set),
              app::time_option(largest, &app::DrawRequest::depiction, &analyse::Depiction::time)}});
        all.rows.push_back(
            option({.name = "--view",
                    .placeholder = "AZIMUTH,ELEVATION",
                    .meaning = "direction of the viewer in degrees: around z from x, and above "
                               "the horizon"},
                   direction_value(), &DrawOptions::direction));
        all.add(&DrawOptions::size,
                app::size_options("size of a drawing in pixels (default: 960x720)"));
        all.add(arrow_options());
        all.add(manner_options(&DrawOptions::manner, "print file name and diagnostics as JSON"));
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
