// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/light_options.hpp"

#include <algorithm>
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

std::optional<render::Environment> read_sky(const std::string& text, Diagnostics& diagnostics) {
    const auto sky = sky_of(std::string_view(text).substr(std::min<std::size_t>(text.size(), 4)));
    if (!sky) {
        refuse(diagnostics, "--environment", text, std::string(sky_syntax));
        return std::nullopt;
    }
    auto made = render::Environment::sky(*sky);
    if (!made) {
        refuse(diagnostics, "--environment", text, made.diagnostics.front().remedy);
        return std::nullopt;
    }
    return *made;
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

void read_light(const LightWords& words, render::Settings& settings, Diagnostics& diagnostics) {
    constexpr double any = 1e6;
    const double rotation =
        read_degrees("--environment-rotation", words.rotation, -any, any, diagnostics);
    const float strength = read_number("--environment-strength", words.strength, 0.0F, 1e30F,
                                       "give a factor of at least 0", diagnostics);
    settings.light.sky_beside_suns = true;
    if (words.sun_angle) {
        settings.light.sun_angle =
            read_degrees("--sun-angle", *words.sun_angle, 0.0, 180.0, diagnostics);
    }
    if (!words.environment || is_file(words)) {
        return;
    }
    std::optional<render::Environment> environment =
        is_sky(*words.environment)
            ? read_sky(*words.environment, diagnostics)
            : std::optional(render::Environment::constant(*color_of(*words.environment)));
    if (environment) {
        settings.light.environment = environment->rotated(rotation).scaled(strength);
    }
}

bool is_file(const LightWords& words) {
    if (!words.environment || is_sky(*words.environment)) {
        return false;
    }
    const auto color = color_of(*words.environment);
    return !color || std::min({color->x, color->y, color->z}) < 0.0F;
}

std::vector<std::filesystem::path> environment_files(const LightWords& words) {
    return is_file(words) ? std::vector<std::filesystem::path>{*words.environment}
                          : std::vector<std::filesystem::path>{};
}

Diagnostics load_environment(const LightWords& words, render::Settings& settings) {
    if (!is_file(words)) {
        return {};
    }
    Result<render::Environment> read = render::Environment::load(*words.environment);
    if (read) {
        const double rotation = degree * degrees_of(words.rotation).value_or(0.0);
        const float strength = number_of<float>(words.strength).value_or(1.0F);
        settings.light.environment = read->rotated(rotation).scaled(strength);
    }
    return std::move(read.diagnostics);
}

}  // namespace balcony::cli
