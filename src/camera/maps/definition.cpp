// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/maps/definition.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "balcony/names.hpp"

namespace balcony::camera::maps {

namespace {

constexpr std::size_t longest_definition = 1000;

// These say nothing about the map.
constexpr std::array without_meaning{"no_defs", "type", "wktext", "no_cut", "R_A"};
// These change PROJ's coordinates, but not the map of the unit sphere.
constexpr std::array without_effect{
    "R",   "a",   "b",     "rf",     "f",        "es",      "ellps",    "datum",     "x_0",
    "y_0", "z_0", "units", "vunits", "to_meter", "towgs84", "nadgrids", "geoidgrids"};
constexpr std::array unsupported{"over", "geoc", "axis", "pm", "lon_wrap"};

template <std::size_t count>
bool is_one_of(const std::array<const char*, count>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

constexpr std::string_view example = R"(for example "robin" or "+proj=lcc +lat_1=30 +lat_2=60")";

std::vector<std::string_view> words_of(std::string_view text) {
    constexpr std::string_view spaces = " \t\r\n\f\v";
    std::vector<std::string_view> words;
    while (true) {
        const std::size_t begin = text.find_first_not_of(spaces);
        if (begin == std::string_view::npos) {
            return words;
        }
        const std::size_t end = std::min(text.find_first_of(spaces, begin), text.size());
        words.push_back(text.substr(begin, end - begin));
        text.remove_prefix(end);
    }
}

bool is_key(std::string_view word) {
    return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
        return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
               c == '_';
    });
}

bool is_numeric(std::string_view key) {
    constexpr std::array numeric{"lonc",   "alpha", "gamma", "theta",        "azi",         "tilt",
                                 "rot_xy", "h",     "k",     "k_0",          "n",           "m",
                                 "q",      "W",     "M",     "north_square", "south_square"};
    return key.starts_with("lat_") || key.starts_with("lon_") || key.starts_with("o_lat_") ||
           key.starts_with("o_lon_") || is_one_of(numeric, key);
}

std::optional<double> number_of(std::string_view text) {
    if (text.starts_with('+')) {
        text.remove_prefix(1);
    }
    double value = 0.0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

}  // namespace

const Definition::Entry* Definition::find(std::string_view key) const {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [key](const Entry& entry) { return entry.key == key; });
    return found == entries.end() ? nullptr : &*found;
}

double Definition::number(std::string_view key, double otherwise) const {
    const Entry* entry = find(key);
    return entry == nullptr ? otherwise : number_of(entry->value).value_or(otherwise);
}

double Definition::angle(std::string_view key, double otherwise) const {
    constexpr double one_degree = std::numbers::pi / 180.0;
    return one_degree * number(key, otherwise / one_degree);
}

void Definition::set(std::string_view key, std::string value) {
    remove(key);
    entries.push_back({std::string(key), std::move(value)});
}

void Definition::remove(std::string_view key) {
    std::erase_if(entries, [key](const Entry& entry) { return entry.key == key; });
}

std::string Definition::text() const {
    std::string text = "+proj=" + projection + " +R=1";
    for (const auto& [key, value] : entries) {
        text += " +" + key;
        if (!value.empty()) {
            text += "=" + value;
        }
    }
    return text;
}

Result<Definition> read_definition(std::string_view text) {
    if (text.size() > longest_definition) {
        return error(
            fmt::format("this definition of a map projection has {} characters, more than {}",
                        text.size(), longest_definition),
            {}, fmt::format("name one projection, {}", example));
    }
    const std::vector<std::string_view> words = words_of(text);
    if (words.empty()) {
        return error("the map projection has no name", {}, fmt::format("write one, {}", example));
    }
    Definition definition;
    Diagnostics warnings;
    std::vector<std::string> ignored;
    for (std::string_view word : words) {
        if (word.starts_with('+')) {
            word.remove_prefix(1);
        }
        const std::size_t equals = word.find('=');
        const std::string key(word.substr(0, equals));
        const std::string value(equals == std::string_view::npos ? "" : word.substr(equals + 1));
        if (key == "step" || value == "pipeline") {
            return error("a transformation of several steps is not a map projection", {},
                         fmt::format("name one projection, {}", example));
        }
        if (key == "init" || word.find(':') != std::string_view::npos) {
            return error(fmt::format("'{}' is the code of a register", word), {},
                         fmt::format("write the projection's own name, {}", example));
        }
        if (word.data() == words[0].data() && equals == std::string_view::npos && is_key(key)) {
            definition.projection = key;
            continue;
        }
        if (is_numeric(key) && !number_of(value)) {
            return error(fmt::format("the value of '{}' is not a number: '{}'", key, value), {},
                         fmt::format("write degrees or a length as a number: {}=30", key));
        }
        if (!is_key(key) || (equals != std::string_view::npos && value.empty())) {
            return error(fmt::format("'{}' is not a parameter of a map projection", word), {},
                         fmt::format("write name=value, {}", example));
        }
        if (is_one_of(unsupported, key)) {
            return error(fmt::format("the parameter '{}' is not supported", key), {},
                         "remove it; a camera is rotated by lon_0 or with move");
        }
        if (is_one_of(without_effect, key)) {
            ignored.push_back(key);
        } else if (key == "proj") {
            definition.projection = value;
        } else if (!is_one_of(without_meaning, key)) {
            definition.set(key, value);
        }
    }
    if (definition.projection.empty()) {
        return error("the map projection has no name", {}, fmt::format("add proj=, {}", example));
    }
    if (!ignored.empty()) {
        warnings.push_back(warning(
            fmt::format("{} {} no effect on this map", all_of(ignored),
                        ignored.size() == 1 ? "has" : "have"),
            {}, "remove what it says: the map is of a sphere of radius 1, about its own origin"));
    }
    return {std::move(definition), std::move(warnings)};
}

}  // namespace balcony::camera::maps
