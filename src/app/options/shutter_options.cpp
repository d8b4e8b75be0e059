// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>

#include "balcony/picture_options.hpp"

namespace balcony::app {

namespace {

constexpr double longest = 1e9;

// A number or, as photographers write seconds, a fraction: 1/50.
std::optional<FrameRate> fraction_of(std::string_view word) {
    const std::size_t slash = word.find('/');
    const bool whole = slash == std::string_view::npos;
    const auto above = number_of<double>(word.substr(0, slash));
    const auto below = whole ? std::optional(1.0) : number_of<double>(word.substr(slash + 1));
    return above && below && *above >= 0.0 && *below > 0.0 && *above / *below <= longest
               ? std::optional(FrameRate{*above, *below})
               : std::nullopt;
}

// In seconds or degrees. Film cameras have a disc that turns once a frame and lets light pass for
// an angle.
void read_duration(std::span<const std::string> words, ShutterRequest& shutter,
                   Diagnostics& found) {
    constexpr std::string_view degrees = "deg";
    std::string_view word = words.back();
    shutter.in_degrees = word.ends_with(degrees);
    word.remove_suffix(shutter.in_degrees ? degrees.size() : 0);
    if (const auto duration = fraction_of(word)) {
        shutter.duration = duration->frames / duration->seconds;
    } else {
        found.push_back(
            refused("--shutter", words.back(),
                    "give seconds from 0, such as 0.02 or 1/50, or an angle such as 180deg"));
    }
}

}  // namespace

Value<FrameRate> frames_per_second() {
    Value<FrameRate> made;
    made.info.type = OptionType::number;
    made.info.unit = "1/s";
    made.info.minimum = 1.0 / longest;
    made.info.maximum = longest;
    made.read = [](std::string_view word) {
        const auto fps = fraction_of(word);
        return fps && fps->frames / fps->seconds >= 1.0 / longest ? fps : std::nullopt;
    };
    made.write = [](const FrameRate& fps) { return fps.text(); };
    made.remedy = [](std::string_view) {
        return "give a number above 0, such as 24 or 30000/1001";
    };
    return made;
}

Options<ShutterRequest> shutter_options() {
    Value<render::ShutterShape> shape = choice(render::shutter_shapes());
    shape.remedy = [](std::string_view word) {
        return suggestion(word, render::shutter_shapes().all(), "the shapes are");
    };
    return {
        {custom_option<ShutterRequest>(
             {.name = "--shutter",
              .placeholder = "SECONDS",
              .meaning = "motion blur: how long the shutter is open, in seconds, such as 0.02 or "
                         "1/50, or in degrees, of which a frame has 360, such as 180deg, with the "
                         "time of the picture in the middle",
              .unit = "s"},
             read_duration,
             [](const ShutterRequest& shutter) {
                 return std::vector{fmt::format("{}", shutter.duration) +
                                    (shutter.in_degrees ? "deg" : "")};
             }),
         option({.name = "--shutter-shape",
                 .placeholder = "NAME",
                 .meaning = "how the shutter moves: " + described(shape.info.choices)},
                shape, &ShutterRequest::shape),
         option({.name = "--fps",
                 .others = {"--framerate", "--frame-rate"},
                 .placeholder = "NUMBER",
                 .meaning = "frames per second of the animation, for a shutter in degrees and "
                            "the layer motion of an EXR file"},
                frames_per_second(), &ShutterRequest::rate)}};
}

}  // namespace balcony::app
