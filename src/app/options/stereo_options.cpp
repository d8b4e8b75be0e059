// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <limits>

#include <fmt/format.h>

#include "app/options/word_parts.hpp"
#include "balcony/picture_options.hpp"

namespace balcony::app {

namespace {

using camera::StereoFormat;
using camera::StereoPair;
using Angles = std::array<double, 2>;

constexpr std::string_view two_files = "files";
std::vector<OptionChoice> formats() {
    std::vector<OptionChoice> made = choices_of(camera::stereo_formats());
    made.push_back({std::string(two_files), "both eyes' pictures in two files"});
    return made;
}

Value<std::vector<StereoFormat>> format_value() {
    return converted<std::vector<StereoFormat>>(
        choice(formats()),
        [](const std::string& name) {
            const auto format = camera::stereo_formats().find(name);
            return format ? std::vector{*format}
                          : std::vector{StereoFormat::left, StereoFormat::right};
        },
        [](const std::vector<StereoFormat>& made) {
            return made.empty()      ? std::string()
                   : made.size() > 1 ? std::string(two_files)
                                     : std::string(camera::stereo_formats()[made.front()].name);
        });
}

Value<double> length(std::string_view option) {
    return number(std::numeric_limits<double>::min(), std::numeric_limits<double>::max(),
                  fmt::format("give a number above 0, in scene units: {} 0.1", option),
                  "scene units");
}

// FROM,TO in degrees.
Value<Angles> merge_angles() {
    Value<Angles> made;
    made.info.unit = "deg";
    made.read = [](std::string_view word) -> std::optional<Angles> {
        const std::vector<std::string_view> parts = parts_of(word, ",");
        const auto from = number_of<double>(parts.front());
        const auto to = number_of<double>(parts.back());
        if (parts.size() != 2 || !from || !to || !(0.0 <= *from && *from < *to && *to <= 90.0)) {
            return std::nullopt;
        }
        return Angles{*from * degree, *to * degree};
    };
    made.write = [](const Angles& angles) {
        return fmt::format("{},{}", angles[0] / degree, angles[1] / degree);
    };
    made.remedy = [](std::string_view) {
        return "give two angles from 0 to 90 degrees, the smaller one first, such as 60,75";
    };
    return made;
}

// Options that do nothing without --stereo.
void refuse_alone(StereoRequest& stereo, const GivenWords& given, Diagnostics& found) {
    for (const char* option : {"--separation", "--convergence", "--baseline", "--merge"}) {
        if (!stereo.is_wanted() && !given.contains("--stereo") && given.contains(option)) {
            found.push_back(error(Kind::usage, fmt::format("{} needs --stereo", option),
                                  "add --stereo side_by_side, say"));
        }
    }
}

}  // namespace

Options<StereoRequest> stereo_options() {
    const auto baselines =
        choice(std::vector<OptionChoice>{{"auto"}, {"fixed"}, {"picture"}, {"level"}});
    return {
        {option({.name = "--stereo",
                 .placeholder = "FORMAT",
                 .meaning = fmt::format(
                     "show what two eyes see: {}, or {} (both eyes' pictures in files whose names "
                     "end in .left and .right)",
                     described(choices_of(camera::stereo_formats()), ", "), two_files)},
                format_value(), &StereoRequest::formats),
         option({.name = "--separation",
                 .placeholder = "LENGTH",
                 .meaning = "of the eyes for --stereo, in scene units (default: 0.064, that of "
                            "people in metres)",
                 .shows_fallback = false},
                length("--separation"), &StereoRequest::pair, &StereoPair::separation),
         option({.name = "--convergence",
                 .placeholder = "LENGTH",
                 .meaning = "for --stereo: the distance of what appears on the screen, in scene "
                            "units (default: infinite)"},
                maybe(length("--convergence")), &StereoRequest::pair, &StereoPair::convergence),
         option({.name = "--baseline",
                 .placeholder = "NAME",
                 .meaning = "for --stereo: auto, fixed (two cameras side by side), picture (across "
                            "each ray, to the right in the picture) or level (across each ray, "
                            "horizontal) (default: auto)",
                 .shows_fallback = false},
                baselines, &StereoRequest::pair, &StereoPair::baseline),
         option({.name = "--merge",
                 .placeholder = "FROM,TO",
                 .meaning = "for --stereo: the degrees above and below the horizon between which "
                            "the separation fades to 0, such as 60,75 for a panorama (default: "
                            "nowhere)"},
                maybe(merge_angles()), &StereoRequest::pair, &StereoPair::merge)},
        {refuse_alone}};
}

}  // namespace balcony::app
