// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/shutter_options.hpp"

#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "balcony/names.hpp"
#include "cli/options/option_values.hpp"

namespace balcony::cli {

namespace {

constexpr double longest = 1e9;

// A number or, as photographers write seconds, a fraction: 1/50.
std::optional<double> fraction_of(std::string_view text) {
    const std::size_t slash = text.find('/');
    const auto above = number_of<double>(text.substr(0, slash));
    const auto below = slash == std::string_view::npos ? std::optional(1.0)
                                                       : number_of<double>(text.substr(slash + 1));
    if (!above || !below || !(*above >= 0.0) || !(*below > 0.0) || !(*above / *below <= longest)) {
        return std::nullopt;
    }
    return *above / *below;
}

std::optional<double> frame_time_of(const ShutterWords& words) {
    const auto fps = fraction_of(words.fps);
    return fps && *fps >= 1.0 / longest ? std::optional(1.0 / *fps) : std::nullopt;
}

// In seconds. Film cameras have a disc that turns once a frame and lets light pass for an angle.
std::optional<double> exposure_of(const ShutterWords& words) {
    constexpr std::string_view degrees = "deg";
    const std::string_view text = words.duration;
    if (!text.ends_with(degrees)) {
        return fraction_of(text);
    }
    const auto angle = fraction_of(text.substr(0, text.size() - degrees.size()));
    const auto frame = frame_time_of(words);
    return angle && frame ? std::optional(*angle / 360.0 * *frame) : std::nullopt;
}

}  // namespace

void add_shutter_options(CLI::App& command, ShutterWords& words) {
    command
        .add_option(
            "--shutter", words.duration,
            "motion blur: how long the shutter is open, in seconds, such as 0.02 or 1/50, or "
            "in degrees, of which a frame has 360, such as 180deg, with the time of the "
            "picture in the middle")
        ->type_name("SECONDS")
        ->capture_default_str();
    std::vector<std::string> shapes;
    for (const std::string& name : render::shutter_shapes().all()) {
        shapes.push_back(
            fmt::format("{} ({})", name,
                        render::shutter_shapes()[*render::shutter_shapes().find(name)].meaning));
    }
    command
        .add_option("--shutter-shape", words.shape,
                    fmt::format("how the shutter moves: {}", fmt::join(shapes, " or ")))
        ->type_name("NAME")
        ->capture_default_str();
    command
        .add_option("--fps", words.fps,
                    "frames per second of the animation, for a shutter in degrees and the layer "
                    "motion of an EXR file")
        ->type_name("NUMBER")
        ->capture_default_str();
}

render::Shutter read_shutter(const ShutterWords& words, Diagnostics& diagnostics) {
    const auto duration = exposure_of(words);
    if (!duration) {
        refuse(diagnostics, "--shutter", words.duration,
               "give seconds from 0, such as 0.02 or 1/50, or an angle such as 180deg");
    }
    const auto shape = render::shutter_shapes().find(words.shape);
    if (!shape) {
        refuse(diagnostics, "--shutter-shape", words.shape,
               suggestion(words.shape, render::shutter_shapes().all(), "the shapes are"));
    }
    return {duration.value_or(0.0), shape.value_or(render::ShutterShape::box)};
}

double read_frame_time(const ShutterWords& words, Diagnostics& diagnostics) {
    const auto seconds = frame_time_of(words);
    if (!seconds) {
        refuse(diagnostics, "--fps", words.fps, "give a number above 0, such as 24 or 30000/1001");
    }
    return seconds.value_or(1.0);
}

}  // namespace balcony::cli
