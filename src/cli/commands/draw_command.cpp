// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "balcony/studies.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/explain_report.hpp"
#include "cli/report/render_observer.hpp"

namespace balcony::cli {

namespace {

struct DrawOptions {
    app::DrawRequest request;  ///< Without its view and its colour.
    std::string output;
    std::array<double, 2> direction{-50.0, 25.0};  ///< Azimuth and elevation in degrees.
    std::optional<Imath::Color3f> color;
    SizeRequest size;
    bool explain = false;
    std::optional<app::FrameNumbers> frames;  ///< Of a film or a sequence.
    app::FrameRate rate;
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

// Two numbers with a comma between them, up to a limit each.
app::Value<std::array<double, 2>> pair(const std::array<double, 2>& limits, std::string unit,
                                       std::string remedy) {
    app::Value<std::array<double, 2>> made;
    made.info.unit = std::move(unit);
    made.read = [limits](std::string_view word) -> std::optional<std::array<double, 2>> {
        const std::size_t comma = std::min(word.find(','), word.size());
        const auto first = app::number_of<double>(word.substr(0, comma));
        const auto second = app::number_of<double>(word.substr(std::min(comma + 1, word.size())));
        return first && second && std::abs(*first) <= limits[0] && std::abs(*second) <= limits[1]
                   ? std::optional(std::array{*first, *second})
                   : std::nullopt;
    };
    made.write = [](const std::array<double, 2>& numbers) {
        return fmt::format("{},{}", numbers[0], numbers[1]);
    };
    made.remedy = [remedy = std::move(remedy)](std::string_view) { return remedy; };
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

// An explanation in lines of a width, in which what goes on is indented.
std::vector<std::string> lines_of(const std::string& text) {
    constexpr std::size_t widest = 90;
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string line = printable(text.substr(begin, end - begin));
        while (line.size() > widest) {
            const std::size_t blank = line.rfind(' ', widest);
            const std::size_t first = line.find_first_not_of(' ');
            const std::size_t cut = blank == line.npos || blank <= first ? widest : blank;
            lines.push_back(line.substr(0, cut));
            line = std::string(first + 4, ' ') + line.substr(line.find_first_not_of(' ', cut));
        }
        lines.push_back(std::move(line));
        begin = end + 1;
    }
    return lines;
}

// What `explain` says of the camera, as notes of its drawing.
void add_notes(const DrawOptions& options, app::DrawRequest& request, Diagnostics& found) {
    const auto wanted = app::read_camera(options.request.camera, options.request.set);
    if (!wanted) {
        found = wanted.diagnostics;
        return;
    }
    const auto made = lang::Workspace().explain(wanted->file, wanted->name, wanted->overrides);
    if (!made) {
        found = made.diagnostics;
        return;
    }
    const auto [width, height] =
        SizeRequest().resolve(made->picture.aspect(), made->picture.parts().size);
    request.view.notes = lines_of(explanation_text(
        made->explanation,
        formulas_text(made->picture, static_cast<double>(width), static_cast<double>(height)),
        width, height));
}

app::DrawRequest request_of(const DrawOptions& options) {
    constexpr double radians = std::numbers::pi / 180.0;
    const std::array<std::size_t, 2> standard = options.explain
                                                    ? std::array<std::size_t, 2>{1920, 1080}
                                                    : std::array<std::size_t, 2>{960, 720};
    const auto [width, height] = options.size.resolve(
        static_cast<double>(standard[0]) / static_cast<double>(standard[1]), standard);
    app::DrawRequest request = options.request;
    request.view = {options.direction[0] * radians, options.direction[1] * radians, width, height};
    if (options.color) {
        request.depiction.color = drawing_color(*options.color);
    }
    request.output = options.output;
    return request;
}

bool is_of_frames(const DrawOptions& options) {
    return options.frames || app::is_film(options.output);
}

Diagnostics draw_frames(const DrawOptions& options, app::DrawRequest drawing) {
    Result<app::FrameOutput> output = app::frame_output_of(options.output);
    if (!output) {
        return output.diagnostics;
    }
    if (!options.frames) {
        return {
            error(Kind::usage, "nothing tells how many frames the film has", "add --frames 48")};
    }
    RenderObserver observer(options.manner);
    return app::draw_film(
        {std::move(drawing), *options.frames, options.rate, std::move(*output.value)},
        observer.observer(), observer.token());
}

ExitCode draw(const DrawOptions& options) {
    Answer answer;
    answer.facts["output"] = nullptr;
    app::DrawRequest request = request_of(options);
    Diagnostics found;
    if (options.explain) {
        add_notes(options, request, found);
    }
    if (!answer.add(found)) {
        return give(answer, options.manner);
    }
    if (is_of_frames(options)) {
        found = draw_frames(options, std::move(request));
    } else {
        const Interruptible work;
        found = app::draw(request, work.token());
    }
    if (answer.add(found)) {
        answer.facts["output"] = options.output;
        answer.text = options.frames
                          ? fmt::format("{}: frames {} drawn\n", printable(options.output),
                                        app::text_of(*options.frames))
                          : fmt::format("{}: drawn\n", printable(options.output));
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
            "output file: a picture (.svg, .png, .jpg, .webp, .tif), a scene (.glb), or with "
            "--frames a film, or a sequence whose name has # for the digits of the frame's number",
            true));
        all.add(
            {{option({.name = "--frames",
                      .placeholder = "FRAMES",
                      .meaning = "draw the frames of a film, as of animate: 1-240, or the length "
                                 "of a film; frame 1 is at --time"},
                     app::maybe(app::frame_numbers()), &DrawOptions::frames),
              option({.name = "--fps",
                      .placeholder = "NUMBER",
                      .meaning = "frames per second of the film"},
                     app::frames_per_second(), &DrawOptions::rate)}});
        all.checks.emplace_back([](DrawOptions& drawn, const app::GivenWords& given, Diagnostics&) {
            const auto frames = given.find("--frames");
            if (frames != given.end() && app::is_film(drawn.output)) {
                drawn.frames = app::frames_of_film(frames->second.back());
            }
        });
        all.add(
            &DrawOptions::request,
            {{app::set_option(&app::DrawRequest::set),
              app::time_option(largest, &app::DrawRequest::depiction, &analyse::Depiction::time),
              option({.name = "--during",
                      .placeholder = "FROM,TO",
                      .meaning = "the times of a film: its drawings, one for each --time, have one "
                                 "frame of reference (default: the times of --frames)"},
                     app::maybe(
                         pair({largest, largest}, "s", "give two times in seconds, such as 0,5")),
                     &app::DrawRequest::depiction, &analyse::Depiction::film)}});
        all.rows.push_back(
            option({.name = "--view",
                    .placeholder = "AZIMUTH,ELEVATION",
                    .meaning = "direction of the viewer in degrees: around z from x, and above "
                               "the horizon"},
                   pair({360.0, 90.0}, "deg",
                        "give two angles in degrees, azimuth from x to the left and elevation, "
                        "such as -50,25"),
                   &DrawOptions::direction));
        all.add(&DrawOptions::size,
                app::size_options(
                    "size of a drawing in pixels (default: 960x720, with --explain 1920x1080)"));
        all.add(arrow_options());
        all.rows.push_back(
            flag({.name = "--explain",
                  .meaning = "write beside the drawing what 'explain' says, with the "
                             "formulas; not in a scene"},
                 true, &DrawOptions::explain));
        all.add(manner_options(&DrawOptions::manner, "print file name and diagnostics as JSON"));
        command.add(std::move(all), options);
        command.footer(
            "Examples:\n"
            "  balcony draw superelliptic -o superelliptic.svg\n"
            "  balcony draw my.cam:closeup --view 120,10 --size 1600x1200 -o closeup.png\n"
            "  balcony draw my.cam:poster -o poster.svg\n"
            "  balcony draw pinhole --explain -o class.svg\n"
            "  balcony draw my.cam:closeup --time 2 --during 0,5 -o closeup-2.png\n"
            "  balcony draw walkthrough --frames 48 -o walkthrough.mp4\n"
            "  balcony draw my.cam --rays 20 --length 2 -o camera.glb");
    };
    add_command<DrawOptions>(app, code, "draw",
                             "draws a camera, or the cameras of a picture, with their rays", draw,
                             describe);
}

}  // namespace balcony::cli
