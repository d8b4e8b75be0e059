// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>

#include "app/options/word_parts.hpp"
#include "balcony/picture_options.hpp"

namespace balcony::app {

namespace {

using Corners = std::optional<std::array<double, 4>>;

// WIDTHxHEIGHT+X+Y as left, top, right and bottom.
Corners pixels_of(std::string_view word) {
    std::array<std::size_t, 4> numbers{};
    const std::vector<std::string_view> parts = parts_of(word, "xX+");
    if (parts.size() != numbers.size() || word.find_first_of("xX") > word.find('+')) {
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

// "0.5" or "50%".
std::optional<double> scale_of(std::string_view word) {
    const bool percent = word.ends_with('%');
    word.remove_suffix(percent ? 1 : 0);
    const auto number = number_of<double>(word);
    return number ? std::optional(percent ? *number / 100.0 : *number) : std::nullopt;
}

// LEFT,TOP,RIGHT,BOTTOM as fractions or percentages.
Corners fractions_of(std::string_view word) {
    std::array<double, 4> corners{};
    const std::vector<std::string_view> parts = parts_of(word, ",");
    if (parts.size() != corners.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto fraction = scale_of(parts[i]);
        if (!fraction || *fraction < 0.0 || *fraction > 1.0) {
            return std::nullopt;
        }
        corners[i] = *fraction;
    }
    return corners[0] < corners[2] && corners[1] < corners[3] ? Corners(corners) : std::nullopt;
}

void read_crop(std::span<const std::string> words, Crop& crop, Diagnostics& found) {
    const std::string& word = words.back();
    if (word.empty()) {
        return;
    }
    crop.in_pixels = word.find_first_of("xX") != std::string::npos;
    crop.corners = crop.in_pixels ? pixels_of(word) : fractions_of(word);
    if (!crop.corners) {
        found.push_back(refused(
            "--crop", word,
            "write --crop 400x300+100+50 for 400 x 300 pixels whose top left is (100, 50), or "
            "--crop 0.25,0.25,0.75,0.75 (25%,25%,75%,75%) for the middle of the picture"));
    }
}

std::vector<std::string> write_crop(const Crop& crop) {
    if (!crop.corners) {
        return {};
    }
    const auto [left, top, right, bottom] = *crop.corners;
    return {crop.in_pixels ? fmt::format("{}x{}+{}+{}", right - left, bottom - top, left, top)
                           : fmt::format("{},{},{},{}", left, top, right, bottom)};
}

}  // namespace

Options<Crop> crop_options() {
    constexpr double max_scale = 100.0;
    Value<double> scale = number(0.0, max_scale, "write a scale such as 50% or 0.5");
    scale.read = [](std::string_view word) {
        const auto read = scale_of(word);
        return read && *read > 0.0 && *read <= max_scale ? read : std::nullopt;
    };
    scale.write = [](double factor) { return fmt::format("{}%", 100.0 * factor); };
    return {{custom_option<Crop>(
                 {.name = "--crop",
                  .others = {"--region"},
                  .placeholder = "REGION",
                  .meaning = "render a part: WIDTHxHEIGHT+X+Y in pixels from the top left, or "
                             "LEFT,TOP,RIGHT,BOTTOM as fractions or percentages of the picture",
                  .type = OptionType::size},
                 read_crop, write_crop),
             option({.name = "--scale",
                     .placeholder = "FACTOR",
                     .meaning = "scale of the size and the region, such as 50%"},
                    scale, &Crop::scale)}};
}

}  // namespace balcony::app
