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
std::optional<app::FrameRate> fraction_of(std::string_view text) {
    const std::size_t slash = text.find('/');
    const auto above = number_of<double>(text.substr(0, slash));
    const auto below = slash == std::string_view::npos ? std::optional(1.0)
                                                       : number_of<double>(text.substr(slash + 1));
    if (!above || !below || !(*above >= 0.0) || !(*below > 0.0) || !(*above / *below <= longest)) {
        return std::nullopt;
    }
    return app::FrameRate{*above, *below};
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

app::ShutterRequest read_shutter(const ShutterWords& words, Diagnostics& diagnostics) {
    constexpr std::string_view degrees = "deg";
    app::ShutterRequest shutter;
    std::string_view text = words.duration;
    shutter.in_degrees = text.ends_with(degrees);
    text.remove_suffix(shutter.in_degrees ? degrees.size() : 0);
    if (const auto duration = fraction_of(text)) {
        shutter.duration = duration->frames / duration->seconds;
    } else {
        refuse(diagnostics, "--shutter", words.duration,
               "give seconds from 0, such as 0.02 or 1/50, or an angle such as 180deg");
    }
    const auto shape = render::shutter_shapes().find(words.shape);
    if (!shape) {
        refuse(diagnostics, "--shutter-shape", words.shape,
               suggestion(words.shape, render::shutter_shapes().all(), "the shapes are"));
    }
    shutter.shape = shape.value_or(render::ShutterShape::box);
    const auto rate = fraction_of(words.fps);
    if (rate && rate->frames / rate->seconds >= 1.0 / longest) {
        shutter.rate = *rate;
    } else {
        refuse(diagnostics, "--fps", words.fps, "give a number above 0, such as 24 or 30000/1001");
    }
    return shutter;
}

}  // namespace balcony::cli
