// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <filesystem>
#include <iostream>
#include <limits>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "balcony/data.hpp"
#include "balcony/studies.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/command_rows.hpp"

namespace balcony::cli {

namespace {

using analyse::V3d;
using app::Located;
using app::LocateRequest;

struct LocateOptions {
    LocateRequest request;
    std::string file;  ///< Of further points.
    Manner manner;
};

// As much of standard input as a table may have and one byte more, so that an endless stream ends
// in an error.
std::vector<std::uint8_t> read_input() {
    std::vector<std::uint8_t> input(data::max_table + 1);
    std::cin.read(reinterpret_cast<char*>(input.data()),
                  static_cast<std::streamsize>(input.size()));
    input.resize(static_cast<std::size_t>(std::cin.gcount()));
    return input;
}

// The rows of a table file, or of standard input if its name is "-".
void read_rows(const std::string& name, std::vector<V3d>& points, Diagnostics& diagnostics) {
    std::error_code ignored;
    if (name != "-" && !std::filesystem::is_regular_file(name, ignored)) {
        const bool there = std::filesystem::exists(name, ignored);
        diagnostics.push_back(there ? error(fmt::format("'{}' is not a file", name), {},
                                            "name a table file, or - for standard input")
                                    : error(fmt::format("there is no file '{}'", name), {},
                                            "check its name and its folder"));
        return;
    }
    const std::vector<std::uint8_t> input =
        name == "-" ? read_input() : std::vector<std::uint8_t>();
    const Result<data::NumberTable> table =
        data::read_table(name == "-" ? data::File::in_memory("standard input", {}, input)
                                     : data::File::on_disk(name));
    diagnostics.insert(diagnostics.end(), table.diagnostics.begin(), table.diagnostics.end());
    for (std::size_t i = 0; table && i < table->rows.size(); ++i) {
        const auto& row = table->rows[i];
        if (row.size() != 3 || row[0].angle || row[1].angle || row[2].angle) {
            diagnostics.push_back(error("this row is not a point",
                                        join(table->at(row.front()), table->at(row.back())),
                                        "write three lengths per line: x,y,z"));
            return;
        }
        points.emplace_back(row[0].value, row[1].value, row[2].value);
    }
}

void check_points(LocateOptions& options, const app::GivenWords& given, Diagnostics& found) {
    if (!given.contains("--point") && options.file.empty()) {
        found.push_back(error(Kind::usage, "no point is given",
                              "add --point X,Y,Z, or --points FILE with one point per line"));
    }
}

app::Option<LocateRequest> point_option() {
    return app::custom_option<LocateRequest>(
        {.name = "--point",
         .placeholder = "X,Y,Z",
         .meaning = "point in space; may be repeated",
         .repeated = true},
        [](std::span<const std::string> words, LocateRequest& request, Diagnostics& found) {
            for (const std::string& word : words) {
                if (const std::optional<V3d> point = app::point_of(word)) {
                    request.points.push_back(*point);
                } else {
                    found.push_back(app::refused("--point", word,
                                                 "write three numbers, such as --point 1,0.5,-2"));
                }
            }
        },
        [](const LocateRequest& request) {
            std::vector<std::string> words;
            for (const V3d& point : request.points) {
                words.push_back(fmt::format("{},{},{}", point.x, point.y, point.z));
            }
            return words;
        });
}

std::string_view text_of(app::AxesSource source) {
    switch (source) {
        case app::AxesSource::request: return "by --axes";
        case app::AxesSource::scene: return "axes of the scene";
        case app::AxesSource::camera: break;
    }
    return "axes of the camera";
}

std::string name_of(const Located& located, const render::Obstacle& obstacle) {
    return located.objects[obstacle.object].name;
}

std::string line_of(const Located& located, std::size_t number) {
    const analyse::Sighting& sighting = located.sightings[number];
    std::string line = fmt::format("\n    x {:>10.4f}   y {:>10.4f}   distance {:.6g}",
                                   sighting.position.x, sighting.position.y, sighting.distance);
    if (located.layers.size() > 1) {
        line += fmt::format("   in layer {}, {}", located.numbers[sighting.layer],
                            printable(located.layers[sighting.layer]));
    }
    if (located.obstacles) {
        const auto& obstacle = (*located.obstacles)[number];
        line += obstacle ? fmt::format("   hidden by {} at distance {:.6g}",
                                       printable(name_of(located, *obstacle)), obstacle->distance)
                         : "   seen";
    }
    return line;
}

std::string text_of(const Located& located) {
    const std::string_view heading = located.obstacles ? " is in the picture at" : " is visible at";
    std::string text = fmt::format("{}, {} x {} pixels; points are read with {} ({})\n",
                                   printable(located.camera), located.width, located.height,
                                   app::axes_text(located.axes), text_of(located.axes_from));
    std::size_t next = 0;
    for (std::size_t number = 0; number < located.points.size(); ++number) {
        const V3d& point = located.points[number];
        text += fmt::format("({}, {}, {})", point.x, point.y, point.z);
        const std::size_t first = next;
        for (; next < located.sightings.size() && located.sightings[next].point == number; ++next) {
            text += next == first ? heading : "";
            text += line_of(located, next);
        }
        text += next == first ? " is not in the picture\n" : "\n";
    }
    return text;
}

nlohmann::json json_of(const Located& located) {
    nlohmann::json points = nlohmann::json::array();
    for (const V3d& point : located.points) {
        points.push_back(
            {{"point", {point.x, point.y, point.z}}, {"sightings", nlohmann::json::array()}});
    }
    for (std::size_t number = 0; number < located.sightings.size(); ++number) {
        const analyse::Sighting& sighting = located.sightings[number];
        nlohmann::json entry{{"x", sighting.position.x},
                             {"y", sighting.position.y},
                             {"layer", sighting.layer},
                             {"distance", sighting.distance}};
        if (located.obstacles) {
            const auto& obstacle = (*located.obstacles)[number];
            entry["hidden_by"] = obstacle ? nlohmann::json{{"object", name_of(located, *obstacle)},
                                                           {"distance", obstacle->distance}}
                                          : nlohmann::json();
        }
        points[sighting.point]["sightings"].push_back(std::move(entry));
    }
    return {{"camera", located.camera},
            {"layers", located.layers},
            {"layer_numbers", located.numbers},
            {"width", located.width},
            {"height", located.height},
            {"closed_form", located.closed_form},
            {"axes", located.axes == Axes::y_up ? "y_up" : "z_up"},
            {"points", std::move(points)}};
}

ExitCode locate(const LocateOptions& options) {
    Answer answer;
    LocateRequest request = options.request;
    if (!options.file.empty()) {
        read_rows(options.file, request.points, answer.diagnostics);
    }
    if (answer.is_done()) {
        const Interruptible work;
        const Result<Located> located = app::locate(request, work.token());
        if (answer.add(located.diagnostics)) {
            answer.facts = json_of(*located);
            answer.text = text_of(*located);
        }
    }
    return give(answer, options.manner);
}

}  // namespace

void add_locate_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, LocateOptions& options) {
        app::Options<LocateOptions> all;
        all.add(&LocateOptions::request,
                {{camera_argument(&LocateRequest::camera), point_option()}});
        all.rows.push_back(option({.name = "--points",
                                   .placeholder = "FILE",
                                   .meaning = "table with one point per line; - is standard input"},
                                  text(OptionType::file), &LocateOptions::file));
        app::Options<LocateRequest> request{
            {scene_option(&LocateRequest::scene,
                          "scene file: also report whether the point is hidden, by which object "
                          "and at which distance"),
             app::set_option(&LocateRequest::set)}};
        request.add(&LocateRequest::placement, app::placement_options());
        request.add(&LocateRequest::size, app::size_options("size of the picture in pixels"));
        request.add(&LocateRequest::size, app::aspect_options());
        request.add(
            {{app::time_option(std::numeric_limits<double>::max(), &LocateRequest::time),
              axes_option(&LocateRequest::axes,
                          "axes of the points: y_up, as in most scenes, or z_up (default: those of "
                          "the scene or, without a scene, of the camera)")}});
        all.add(&LocateOptions::request, std::move(request));
        all.add(manner_options(&LocateOptions::manner, "print the positions as JSON"));
        all.checks.emplace_back(check_points);
        command.add(std::move(all), options);
        command.footer(
            "Examples:\n"
            "  balcony locate panorama --point 3,2,0.5\n"
            "  balcony locate pinhole --set fov=90deg --size 1920x1080 --axes y_up --point 1,0,-4\n"
            "  balcony locate my.cam:closeup --scene room.glb --fit --point 0,0.5,-1\n"
            "  balcony locate my.cam:closeup --points corners.csv --json");
    };
    add_command<LocateOptions>(app, code, "locate",
                               "finds the positions in a picture that show given points in space",
                               locate, describe);
}

}  // namespace balcony::cli
