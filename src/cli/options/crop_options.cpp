// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/crop_options.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/option_values.hpp"

namespace balcony::cli {

namespace {

std::vector<std::string_view> parts_of(std::string_view text, std::string_view separators) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find_first_of(separators);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) {
            return parts;
        }
        text.remove_prefix(end + 1);
    }
}

// "0.5" or "50%".
std::optional<double> fraction_of(std::string_view text) {
    const bool percent = text.ends_with('%');
    text.remove_suffix(percent ? 1 : 0);
    const auto number = number_of<double>(text);
    return number ? std::optional(percent ? *number / 100.0 : *number) : std::nullopt;
}

// WIDTHxHEIGHT+X+Y as left, top, right and bottom.
std::optional<std::array<double, 4>> pixels_of(std::string_view text) {
    std::array<std::size_t, 4> numbers{};
    const std::vector<std::string_view> parts = parts_of(text, "xX+");
    if (parts.size() != numbers.size() || text.find_first_of("xX") > text.find('+')) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto number = number_of<std::size_t>(parts[i]);
        if (!number || (i < 2 && *number == 0)) {
            return std::nullopt;
        }
        numbers[i] = *number;
    }
    const auto [width, height, x, y] = numbers;
    return std::array{static_cast<double>(x), static_cast<double>(y),
                      static_cast<double>(x) + static_cast<double>(width),
                      static_cast<double>(y) + static_cast<double>(height)};
}

// LEFT,TOP,RIGHT,BOTTOM as fractions or percentages.
std::optional<std::array<double, 4>> fractions_of(std::string_view text) {
    std::array<double, 4> corners{};
    const std::vector<std::string_view> parts = parts_of(text, ",");
    if (parts.size() != corners.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto fraction = fraction_of(parts[i]);
        if (!fraction || *fraction < 0.0 || *fraction > 1.0) {
            return std::nullopt;
        }
        corners[i] = *fraction;
    }
    return corners[0] < corners[2] && corners[1] < corners[3] ? std::optional(corners)
                                                              : std::nullopt;
}

}  // namespace

void add_crop_options(CLI::App& command, CropWords& words) {
    command
        .add_option("--crop", words.crop,
                    "render a part: WIDTHxHEIGHT+X+Y in pixels from the top left, or "
                    "LEFT,TOP,RIGHT,BOTTOM as fractions or percentages of the picture")
        ->type_name("REGION");
    command.add_option("--scale", words.scale, "scale of the size and the region, such as 50%")
        ->type_name("FACTOR")
        ->capture_default_str();
}

Crop read_crop(const CropWords& words, Diagnostics& diagnostics) {
    Crop crop;
    const auto scale = fraction_of(words.scale);
    constexpr double max_scale = 100.0;
    if (scale && *scale > 0.0 && *scale <= max_scale) {
        crop.scale = *scale;
    } else {
        refuse(diagnostics, "--scale", words.scale, "write a scale such as 50% or 0.5");
    }
    if (words.crop.empty()) {
        return crop;
    }
    crop.in_pixels = words.crop.find_first_of("xX") != std::string::npos;
    crop.corners = crop.in_pixels ? pixels_of(words.crop) : fractions_of(words.crop);
    if (!crop.corners) {
        refuse(diagnostics, "--crop", words.crop,
               "write --crop 400x300+100+50 for 400 x 300 pixels whose top left is (100, 50), or "
               "--crop 0.25,0.25,0.75,0.75 (25%,25%,75%,75%) for the middle of the picture");
    }
    return crop;
}

}  // namespace balcony::cli
