// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <iostream>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "balcony/data.hpp"
#include "balcony/names.hpp"
#include "balcony/output_file.hpp"
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
    std::string output;
    Manner manner;
};

void check_points(LocateOptions& options, const app::GivenWords& given, Diagnostics& found) {
    if (!given.contains("--point") && options.file.empty()) {
        found.push_back(error(Kind::usage, "no point is given",
                              "add --point X,Y,Z, or --points FILE with one point per line"));
    }
    if (!options.output.empty() && ending_of(options.output) != ".npy") {
        found.push_back(
            error(Kind::usage,
                  fmt::format("the file extension of '{}' is not that of an array", options.output),
                  "use a file name that ends in .npy, or omit --output for text"));
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

std::string heading(const Located& located) {
    return fmt::format("{}, {} x {} pixels; points are read with {} ({})\n",
                       printable(located.camera), located.width, located.height,
                       app::axes_text(located.axes), text_of(located.axes_from));
}

std::string text_of(const Located& located) {
    const std::string_view heading = located.obstacles ? " is in the picture at" : " is visible at";
    std::string text;
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

nlohmann::json points_json(const Located& located) {
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
    return points;
}

nlohmann::json facts_of(const Located& located) {
    return {{"camera", located.camera},
            {"layers", located.layers},
            {"layer_numbers", located.numbers},
            {"width", located.width},
            {"height", located.height},
            {"closed_form", located.closed_form},
            {"axes", located.axes == Axes::y_up ? "y_up" : "z_up"}};
}

/// An array with a row for each sighting.
class SightingArray {
public:
    explicit SightingArray(const std::string& file) : output_(file) { write_header(); }

    void add(const Located& located, std::size_t points_before) {
        columns_ = located.obstacles ? 6 : 5;
        std::vector<double> numbers;
        for (std::size_t i = 0; i < located.sightings.size(); ++i) {
            const analyse::Sighting& one = located.sightings[i];
            numbers.insert(numbers.end(),
                           {static_cast<double>(points_before + one.point), one.position.x,
                            one.position.y, static_cast<double>(one.layer), one.distance});
            if (located.obstacles) {
                numbers.push_back((*located.obstacles)[i] ? 1.0 : 0.0);
            }
        }
        rows_ += located.sightings.size();
        output_.stream().write(reinterpret_cast<const char*>(numbers.data()),
                               static_cast<std::streamsize>(numbers.size() * sizeof(double)));
    }
    [[nodiscard]] Diagnostics finish() {
        output_.stream().seekp(0);
        write_header();
        return output_.commit();
    }
    [[nodiscard]] std::size_t rows() const { return rows_; }

private:
    void write_header() {
        constexpr std::size_t room = 128;  // For any number of rows.
        output_.stream() << npy_header(std::array{rows_, columns_}, sizeof(double), room);
    }

    OutputFile output_;
    std::size_t rows_ = 0;
    std::size_t columns_ = 5;
};

// Waiting for standard input in between is ended by the signal itself.
template <class Make>
auto interruptible(const Make& make) {
    const Interruptible work;
    return make(work.token());
}

/// Where the points of a command come from, batch by batch, and what is made of their sightings.
class Run {
public:
    Run(const LocateOptions& options, Answer& answer) : options_(options), answer_(answer) {}

    void operator()() {
        if (!open_points()) {
            return;
        }
        auto session = interruptible([this](const std::stop_token& stop) {
            return app::LocateSession::make(options_.request, stop);
        });
        if (!answer_.add(session.diagnostics) || !open_output(session->files())) {
            return;
        }
        std::vector<V3d> points = options_.request.points;
        while (points.empty() ? next(points) : true) {
            const std::size_t count = points.size();
            const Result<Located> located = interruptible([&](const std::stop_token& stop) {
                return session->locate(std::exchange(points, {}), stop);
            });
            if (!answer_.add(located.diagnostics)) {
                return;
            }
            use(*located);
            count_ += count;
        }
        if (answer_.is_done() && answer_.add(interruptible([&](const std::stop_token& stop) {
                return session->finish(stop);
            })) &&
            array_ && answer_.add(array_->finish())) {
            answer_.facts["output"] = options_.output;
            answer_.facts["sightings"] = array_->rows();
            answer_.text =
                fmt::format("{}: {} of {}\n", printable(options_.output),
                            counted(array_->rows(), "sighting"), counted(count_, "point"));
        }
    }

private:
    bool open_points() {
        if (options_.file == "-") {
            reader_.emplace(std::cin, "standard input");
        } else if (!options_.file.empty()) {
            auto opened = data::PointReader::open(options_.file);
            if (!answer_.add(opened.diagnostics)) {
                return false;
            }
            reader_.emplace(std::move(*opened));
        }
        return true;
    }

    bool open_output(std::vector<std::filesystem::path> inputs) {
        if (options_.output.empty()) {
            return true;
        }
        inputs.emplace_back(options_.file);
        if (!answer_.add(OutputFile::check(options_.output)) ||
            !answer_.add(app::check_overwrites(options_.output, inputs))) {
            return false;
        }
        array_.emplace(options_.output);
        return true;
    }

    // The next points of the file; false if there are no more or they cannot be read.
    bool next(std::vector<V3d>& points) {
        if (!reader_) {
            return false;
        }
        auto read = reader_->next();
        if (!answer_.add(read.diagnostics)) {
            return false;
        }
        points = std::move(*read);
        return !points.empty();
    }

    void use(const Located& located) {
        const bool first = count_ == 0;
        if (first) {
            answer_.facts = facts_of(located);
            if (!array_) {
                answer_.facts["points"] = nlohmann::json::array();
            }
        }
        if (array_) {
            array_->add(located, count_);
        } else if (options_.manner.json) {
            nlohmann::json points = points_json(located);
            nlohmann::json& all = answer_.facts["points"];
            all.insert(all.end(), points.begin(), points.end());
        } else if (!options_.manner.quiet) {
            print_result((first ? heading(located) : "") + text_of(located));
        }
    }

    const LocateOptions& options_;
    Answer& answer_;
    std::optional<data::PointReader> reader_{};
    std::optional<SightingArray> array_{};
    std::size_t count_ = 0;
};

ExitCode locate(const LocateOptions& options) {
    Answer answer;
    Run(options, answer)();
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
                                   .meaning = "table with one point per line, or an array of NumPy "
                                              "(.npy) of the shape (points, 3); - is standard "
                                              "input"},
                                  text(OptionType::file), &LocateOptions::file));
        all.rows.push_back(output_option(
            &LocateOptions::output,
            "array of NumPy (.npy) with a row for each sighting: number of the point from 0, x, y, "
            "layer from 0, distance and, with --scene, 1 if it is hidden (default: text)"));
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
            "  balcony locate my.cam:closeup --points corners.csv --json\n"
            "  balcony locate my.cam:closeup --points cloud.npy -o seen.npy");
    };
    add_command<LocateOptions>(app, code, "locate",
                               "finds the positions in a picture that show given points in space",
                               locate, describe);
}

}  // namespace balcony::cli
