// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/common_options.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "balcony/names.hpp"
#include "cli/options/option_values.hpp"

namespace balcony::cli {

namespace {

using app::max_side;

std::optional<std::size_t> side_of(std::string_view digits) {
    const auto pixels = number_of<std::size_t>(digits);
    return pixels && *pixels >= 1 && *pixels <= max_side ? pixels : std::nullopt;
}

std::optional<std::size_t> read_side(std::string_view option, const std::string& text,
                                     Diagnostics& diagnostics) {
    const auto side = side_of(text);
    if (!side && !text.empty()) {
        refuse(diagnostics, option, text, fmt::format("give 1 to {} pixels", max_side));
    }
    return side;
}

camera::Fit read_fit(const std::string& text, Diagnostics& diagnostics) {
    const std::optional<camera::Fit> fit = camera::fits().find(text);
    if (!fit) {
        refuse(diagnostics, "--aspect", text,
               suggestion(text, camera::fits().all(), "the choices are"));
    }
    return fit.value_or(camera::Fit::fit);
}

}  // namespace

void add_size_options(CLI::App& command, SizeWords& words, const std::string& meaning) {
    command.add_option("--size", words.size, meaning)->type_name("WIDTH[xHEIGHT]");
    command.add_option("-W,--width", words.width, "width in pixels; alone, as --size WIDTH")
        ->type_name("PIXELS");
    command
        .add_option("-H,--height", words.height,
                    "height in pixels; alone, the width follows from the aspect ratio")
        ->type_name("PIXELS");
}

PictureSize read_size(const SizeWords& words, Diagnostics& diagnostics) {
    PictureSize size{read_side("--width", words.width, diagnostics),
                     read_side("--height", words.height, diagnostics),
                     read_fit(words.fit, diagnostics)};
    if (words.size.empty()) {
        return size;
    }
    if (!words.width.empty() || !words.height.empty()) {
        diagnostics.push_back(error("--size and --width or --height exclude each other", {},
                                    "write --size 1920x1080, or --width 1920 --height 1080"));
        return {};
    }
    const std::string_view whole = words.size;
    const std::size_t cross = whole.find_first_of("xX");
    size.width = side_of(whole.substr(0, cross));
    if (cross != std::string_view::npos) {
        size.height = side_of(whole.substr(cross + 1));
    }
    if (!size.width || (cross != std::string_view::npos && !size.height)) {
        refuse(diagnostics, "--size", words.size,
               fmt::format("write --size 1920x1080, or --size 1920 for the camera's aspect ratio; "
                           "a side has 1 to {} pixels",
                           max_side));
    }
    return size;
}

void add_aspect_option(CLI::App& command, SizeWords& words) {
    std::vector<std::string> modes;
    for (const std::string& name : camera::fits().all()) {
        modes.push_back(
            fmt::format("{} ({})", name, camera::fits()[*camera::fits().find(name)].meaning));
    }
    command
        .add_option("--aspect", words.fit,
                    fmt::format("what the picture does in a size of another aspect ratio: {}; a "
                                "camera with 'square' in its map shows more or less instead",
                                fmt::join(modes, ", ")))
        ->type_name("MODE")
        ->capture_default_str();
}

void add_time_option(CLI::App& command, std::string& time) {
    command
        .add_option("--time", time,
                    "the time in seconds: of the scene's animations, and t in the camera's "
                    "formulas")
        ->type_name("T")
        ->capture_default_str();
}

std::optional<Axes> read_axes(const std::string& text, Diagnostics& diagnostics) {
    if (!text.empty() && text != "y_up" && text != "z_up") {
        refuse(diagnostics, "--axes", text, "write y_up or z_up");
    }
    return text.empty() ? std::nullopt : std::optional(text == "y_up" ? Axes::y_up : Axes::z_up);
}

void add_quiet_option(CLI::App& command, bool& quiet) {
    command.add_flag("-q,--quiet", quiet, "print only warnings and errors");
}

}  // namespace balcony::cli
