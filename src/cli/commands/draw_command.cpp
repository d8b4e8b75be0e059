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
#include "balcony/output_file.hpp"
#include "balcony/scene.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/options/common_options.hpp"
#include "cli/options/option_values.hpp"
#include "cli/report/json.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

struct DrawOptions {
    std::string camera;
    std::string output;
    std::vector<std::string> set;
    std::string time = "0";
    std::string view = "-50,25";
    SizeWords size;
    std::string rays = "9";
    std::string length = "auto";
    std::string color = "auto";
    bool no_eye = false;
    bool no_toward = false;
    bool no_frame = false;
    bool no_axes = false;
    bool quiet = false;
    bool json = false;
};

struct Outcome {
    ExitCode code = ExitCode::done;
    Diagnostics diagnostics;
};

constexpr double largest = 1e12;

// From a linear colour, as in the options of render, to bytes of sRGB.
std::optional<analyse::DrawingColor> read_color(const std::string& text, Diagnostics& diagnostics) {
    if (text == "auto") {
        return std::nullopt;
    }
    const auto color = color_of(text);
    if (!color || std::min({color->x, color->y, color->z}) < 0.0F ||
        std::max({color->x, color->y, color->z}) > 1.0F) {
        refuse(diagnostics, "--color", text,
               "give auto, a grey level such as 0.2, or red,green,blue, each from 0 to 1");
        return std::nullopt;
    }
    const auto byte = [](float level) {
        constexpr float straight = 0.0031308F;
        const float encoded =
            level <= straight ? 12.92F * level : 1.055F * std::pow(level, 1.0F / 2.4F) - 0.055F;
        return static_cast<std::uint8_t>(std::lround(255.0F * encoded));
    };
    return analyse::DrawingColor{byte(color->x), byte(color->y), byte(color->z)};
}

analyse::Depiction read_depiction(const DrawOptions& options, Diagnostics& diagnostics) {
    analyse::Depiction depiction;
    constexpr std::size_t max_rays = 100;
    depiction.rays = read_count("--rays", options.rays, 0, max_rays, diagnostics);
    if (options.length != "auto") {
        depiction.length =
            read_number("--length", options.length, 1e-12, largest,
                        "give auto, or a length above 0 in scene units", diagnostics);
    }
    depiction.color = read_color(options.color, diagnostics);
    depiction.time =
        read_number("--time", options.time, -largest, largest, "give a number", diagnostics);
    depiction.eye = !options.no_eye;
    depiction.toward = !options.no_toward;
    depiction.frame = !options.no_frame;
    depiction.axes = !options.no_axes;
    return depiction;
}

// Two numbers with a separator between them; nothing if either is invalid.
template <class Number>
std::optional<std::array<Number, 2>> two_of(std::string_view text, std::string_view separators) {
    const std::size_t cut = text.find_first_of(separators);
    if (cut == std::string_view::npos) {
        return std::nullopt;
    }
    const auto first = number_of<Number>(text.substr(0, cut));
    const auto second = number_of<Number>(text.substr(cut + 1));
    return first && second ? std::optional(std::array{*first, *second}) : std::nullopt;
}

analyse::DrawingView read_view(const DrawOptions& options, Diagnostics& diagnostics) {
    analyse::DrawingView view;
    const auto angles = two_of<double>(options.view, ",");
    constexpr double radians = std::numbers::pi / 180.0;
    if (angles && std::abs((*angles)[0]) <= 360.0 && std::abs((*angles)[1]) <= 90.0) {
        view.azimuth = (*angles)[0] * radians;
        view.elevation = (*angles)[1] * radians;
    } else {
        refuse(diagnostics, "--view", options.view,
               "give two angles in degrees, azimuth from x to the left and elevation, such as "
               "-50,25");
    }
    constexpr std::size_t minimum = 16;
    constexpr std::size_t maximum = 16384;
    constexpr std::array<std::size_t, 2> standard{960, 720};
    const auto [width, height] = read_size(options.size, diagnostics).resolve(4.0 / 3.0, standard);
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

ExitCode check_output(const fs::path& file, const fs::path& camera, Diagnostics& diagnostics) {
    if (!format_of(file)) {
        diagnostics.push_back(
            error(fmt::format("the file extension of '{}' is not a drawing format", file.string()),
                  {}, "use a file name that ends in .svg, .png, .jpg, .webp, .tif or .glb"));
        return ExitCode::wrong_usage;
    }
    std::error_code failed;
    if (fs::equivalent(file, camera, failed) && !failed) {
        diagnostics.push_back(
            error(fmt::format("'{}' is the camera file and would be overwritten", file.string()),
                  {}, "name another file with --output"));
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
    const Image image = analyse::rasterise(drawing);
    return render::write_samples(image.samples, {image.width, image.height, 3}, file);
}

// An error of the camera is in the first value, an error of writing in the second.
struct Written {
    Diagnostics camera, file;
};

Written write(const camera::Picture& picture, const analyse::Depiction& depiction,
              const analyse::DrawingView& view, const fs::path& file) {
    const Format format = *format_of(file);
    if (format == Format::glb) {
        const auto scene = analyse::model(picture, depiction);
        if (!scene) {
            return {scene.diagnostics, {}};
        }
        return {scene.diagnostics, write_whole(file, scene::to_glb(*scene))};
    }
    const auto drawing = analyse::draw(picture, depiction, view);
    return {drawing.diagnostics, drawing ? write_drawing(*drawing, format, file) : Diagnostics{}};
}

Outcome make_drawing(const DrawOptions& options) {
    Outcome outcome;
    const auto add = [&outcome](const Diagnostics& diagnostics, ExitCode code) {
        outcome.diagnostics.insert(outcome.diagnostics.end(), diagnostics.begin(),
                                   diagnostics.end());
        outcome.code = has_errors(diagnostics) ? code : outcome.code;
    };
    Diagnostics usage;
    const analyse::Depiction depiction = read_depiction(options, usage);
    const analyse::DrawingView view = read_view(options, usage);
    add(usage, ExitCode::wrong_usage);
    if (outcome.code == ExitCode::done) {
        outcome.code =
            check_output(options.output, camera_file(options.camera), outcome.diagnostics);
    }
    if (outcome.code != ExitCode::done) {
        return outcome;
    }
    const auto picture = load_picture(options.camera, options.set);
    add(picture.diagnostics, ExitCode::bad_input);
    if (picture) {
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
    const auto describe = [](CLI::App& command, DrawOptions& options) {
        add_camera_option(command, options.camera);
        command
            .add_option("-o,--output", options.output,
                        "output file: a picture (.svg, .png, .jpg, .webp, .tif) or a scene (.glb)")
            ->type_name("FILE")
            ->required();
        add_set_option(command, options.set);
        const auto value = [&](const char* names, std::string& text, const char* meaning,
                               const char* type) {
            command.add_option(names, text, meaning)->type_name(type)->capture_default_str();
        };
        add_time_option(command, options.time);
        value("--view", options.view,
              "direction of the viewer in degrees: around z from x, and above the horizon",
              "AZIMUTH,ELEVATION");
        add_size_options(command, options.size, "size of a drawing in pixels (default: 960x720)");
        value("--rays", options.rays,
              "number of arrows along the longer side of the camera's picture", "COUNT");
        value("--length", options.length, "length of the arrows in scene units", "LENGTH");
        value("--color", options.color,
              "colour of the arrows: a grey level, or red,green,blue (linear, from 0 to 1)",
              "COLOUR");
        command.add_flag("--no-eye", options.no_eye, "omit the eye object");
        command.add_flag("--no-toward", options.no_toward, "omit the direction object");
        command.add_flag("--no-frame", options.no_frame, "omit the picture's border");
        command.add_flag("--no-axes", options.no_axes, "omit the axes");
        add_quiet_option(command, options.quiet);
        command.add_flag("--json", options.json, "print file name and diagnostics as JSON");
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
