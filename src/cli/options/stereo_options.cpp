// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/stereo_options.hpp"

#include <array>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/option_values.hpp"

namespace balcony::cli {

namespace {

using camera::StereoFormat;

constexpr std::string_view two_files = "files";

double read_length(std::string_view option, const std::string& text, Diagnostics& diagnostics) {
    constexpr double smallest = std::numeric_limits<double>::min();
    constexpr double largest = std::numeric_limits<double>::max();
    return read_number(option, text, smallest, largest,
                       fmt::format("give a number above 0, in scene units: {} 0.1", option),
                       diagnostics);
}

// FROM,TO in degrees.
std::optional<std::array<double, 2>> angles_of(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) {
        return std::nullopt;
    }
    const auto from = number_of<double>(text.substr(0, comma));
    const auto to = number_of<double>(text.substr(comma + 1));
    if (!from || !to || !(0.0 <= *from && *from < *to && *to <= 90.0)) {
        return std::nullopt;
    }
    constexpr double per_degree = std::numbers::pi / 180.0;
    return std::array{*from * per_degree, *to * per_degree};
}

// An option that does nothing without --stereo.
void refuse_alone(const StereoWords& words, Diagnostics& diagnostics) {
    const std::array<std::pair<std::string_view, const std::string*>, 4> options{
        {{"--separation", &words.separation},
         {"--convergence", &words.convergence},
         {"--baseline", &words.baseline},
         {"--merge", &words.merge}}};
    for (const auto& [option, text] : options) {
        if (!text->empty()) {
            diagnostics.push_back(error(fmt::format("{} needs --stereo", option), {},
                                        "add --stereo side_by_side, say"));
        }
    }
}

}  // namespace

void add_stereo_options(CLI::App& command, StereoWords& words) {
    std::string formats;
    for (const std::string& name : camera::stereo_formats().all()) {
        formats +=
            fmt::format("{} ({}), ", name,
                        camera::stereo_formats()[*camera::stereo_formats().find(name)].meaning);
    }
    command
        .add_option("--stereo", words.format,
                    fmt::format("show what two eyes see: {}or {} (both eyes' pictures in files "
                                "whose names end in .left and .right)",
                                formats, two_files))
        ->type_name("FORMAT");
    command
        .add_option("--separation", words.separation,
                    "of the eyes for --stereo, in scene units (default: 0.064, that of people in "
                    "metres)")
        ->type_name("LENGTH");
    command
        .add_option("--convergence", words.convergence,
                    "for --stereo: the distance of what appears on the screen, in scene units "
                    "(default: infinite)")
        ->type_name("LENGTH");
    command
        .add_option("--baseline", words.baseline,
                    "for --stereo: auto, fixed (two cameras side by side), picture (across each "
                    "ray, to the right in the picture) or level (across each ray, horizontal) "
                    "(default: auto)")
        ->type_name("NAME");
    command
        .add_option("--merge", words.merge,
                    "for --stereo: the degrees above and below the horizon between which the "
                    "separation fades to 0, such as 60,75 for a panorama (default: nowhere)")
        ->type_name("FROM,TO");
}

StereoRequest read_stereo(const StereoWords& words, Diagnostics& diagnostics) {
    if (words.format.empty()) {
        refuse_alone(words, diagnostics);
        return {};
    }
    StereoRequest request;
    std::vector<std::string> known = camera::stereo_formats().all();
    known.emplace_back(two_files);
    check_name("--stereo", words.format, known, diagnostics);
    request.formats = {
        camera::stereo_formats().find(words.format).value_or(StereoFormat::side_by_side)};
    if (words.format == two_files) {
        request.formats = {StereoFormat::left, StereoFormat::right};
    }
    if (!words.separation.empty()) {
        request.pair.separation = read_length("--separation", words.separation, diagnostics);
    }
    if (!words.convergence.empty()) {
        request.pair.convergence = read_length("--convergence", words.convergence, diagnostics);
    }
    if (!words.baseline.empty()) {
        check_name("--baseline", words.baseline, {"auto", "fixed", "picture", "level"},
                   diagnostics);
        request.pair.baseline = words.baseline;
    }
    if (!words.merge.empty()) {
        request.pair.merge = angles_of(words.merge);
        if (!request.pair.merge) {
            refuse(diagnostics, "--merge", words.merge,
                   "give two angles from 0 to 90 degrees, the smaller one first, such as 60,75");
        }
    }
    return request;
}

}  // namespace balcony::cli
