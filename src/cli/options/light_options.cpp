// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/light_options.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string_view>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/option_values.hpp"

namespace balcony::cli {

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr std::string_view sky_syntax =
    "write sky, or for example sky:elevation=30,azimuth=135,turbidity=3";

bool is_sky(std::string_view text) { return text == "sky" || text.starts_with("sky:"); }

/// A number of degrees, with or without a unit.
std::optional<double> degrees_of(std::string_view text) {
    if (text.ends_with("deg")) {
        text.remove_suffix(3);
    }
    return number_of<double>(text);
}

double read_degrees(std::string_view option, const std::string& text, double minimum,
                    double maximum, Diagnostics& diagnostics) {
    const auto angle = degrees_of(text);
    if (!angle || *angle < minimum || *angle > maximum) {
        refuse(diagnostics, option, text,
               fmt::format("give degrees from {} to {}", minimum, maximum));
        return 0.0;
    }
    return degree * *angle;
}

/// The words after "sky:".
std::optional<render::Sky> sky_of(std::string_view text) {
    render::Sky sky;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(','));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        const std::size_t equals = word.find('=');
        if (equals == std::string_view::npos) {
            return std::nullopt;
        }
        const std::string_view name = word.substr(0, equals);
        const auto value = degrees_of(word.substr(equals + 1));
        if (!value) {
            return std::nullopt;
        }
        if (name == "elevation") {
            sky.elevation = degree * *value;
        } else if (name == "azimuth") {
            sky.azimuth = degree * *value;
        } else if (name == "turbidity") {
            sky.turbidity = *value;
        } else {
            return std::nullopt;
        }
    }
    return sky;
}

void read_environment(const std::string& text, app::LightRequest& light, Diagnostics& diagnostics) {
    const auto color = color_of(text);
    if (!is_sky(text)) {
        if (color && std::min({color->x, color->y, color->z}) >= 0.0F) {
            light.environment = *color;
        } else {
            light.environment = std::filesystem::path(text);
        }
        return;
    }
    const auto sky = sky_of(std::string_view(text).substr(std::min<std::size_t>(text.size(), 4)));
    const auto made = sky ? render::Environment::sky(*sky) : Result<render::Environment>();
    if (!sky || !made) {
        refuse(diagnostics, "--environment", text,
               sky ? made.diagnostics.front().remedy : std::string(sky_syntax));
        return;
    }
    light.environment = *sky;
}

}  // namespace

void add_light_options(CLI::App& command, LightWords& words) {
    command
        .add_option("--environment", words.environment,
                    "light from far away, for path: an equirectangular picture (.hdr, .exr, ...), "
                    "a radiance or red,green,blue, or a sky such as "
                    "sky:elevation=30,azimuth=135,turbidity=3 (degrees; azimuth clockwise from "
                    "north). Default for a scene without light: a soft sky, or in a closed room a "
                    "light at the eye; for one with suns alone: a soft sky, unless it is closed")
        ->type_name("FILE|COLOUR|sky");
    command
        .add_option("--environment-rotation", words.rotation,
                    "turns the environment counterclockwise about the vertical axis")
        ->type_name("DEGREES")
        ->capture_default_str();
    command
        .add_option("--environment-strength", words.strength,
                    "factor for the radiance of the environment")
        ->type_name("FACTOR")
        ->capture_default_str();
    command
        .add_option("--sun-angle", words.sun_angle,
                    "angular diameter of directional lights, for path; 0 gives sharp shadows "
                    "(default: that of the scene, or of the sun, 0.53)")
        ->type_name("DEGREES");
}

app::LightRequest read_light(const LightWords& words, Diagnostics& diagnostics) {
    constexpr double any = 1e6;
    app::LightRequest light;
    light.rotation = read_degrees("--environment-rotation", words.rotation, -any, any, diagnostics);
    light.strength = read_number("--environment-strength", words.strength, 0.0F, 1e30F,
                                 "give a factor of at least 0", diagnostics);
    if (words.sun_angle) {
        light.sun_angle = read_degrees("--sun-angle", *words.sun_angle, 0.0, 180.0, diagnostics);
    }
    if (words.environment) {
        read_environment(*words.environment, light, diagnostics);
    }
    return light;
}

}  // namespace balcony::cli
