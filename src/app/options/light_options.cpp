// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "app/options/word_parts.hpp"
#include "balcony/picture_options.hpp"

namespace balcony::app {

namespace {

bool is_sky(std::string_view word) { return word == "sky" || word.starts_with("sky:"); }

std::string_view without_unit(std::string_view word) {
    return word.ends_with("deg") ? word.substr(0, word.size() - 3) : word;
}

Value<double> any_degrees() {
    constexpr double any = 1e6;
    return degrees(-any, any);
}

// The words after "sky:".
std::optional<render::Sky> sky_of(std::string_view word) {
    render::Sky sky;
    word.remove_prefix(std::min<std::size_t>(word.size(), 4));
    for (const std::string_view part : parts_of(word, ",")) {
        if (part.empty()) {
            continue;
        }
        const std::size_t equals = std::min(part.find('='), part.size() - 1);
        const std::string_view name = part.substr(0, equals);
        const auto value = number_of<double>(without_unit(part.substr(equals + 1)));
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

void read_environment(std::span<const std::string> words, LightRequest& light, Diagnostics& found) {
    const std::string& word = words.back();
    if (!is_sky(word)) {
        const auto radiance = color(std::numeric_limits<float>::infinity(), {}).read(word);
        light.environment.emplace<std::filesystem::path>(word);
        if (radiance) {
            light.environment = *radiance;
        }
        return;
    }
    const auto sky = sky_of(word);
    const auto made = sky ? render::Environment::sky(*sky) : Result<render::Environment>();
    if (!made) {
        found.push_back(
            refused("--environment", word,
                    sky ? made.diagnostics.front().remedy
                        : "write sky, or for example sky:elevation=30,azimuth=135,turbidity=3"));
        return;
    }
    light.environment = *sky;
}

struct EnvironmentWord {
    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(const std::filesystem::path& file) const { return file.string(); }
    std::string operator()(const Imath::Color3f& radiance) const {
        return color(std::numeric_limits<float>::infinity(), {}).write(radiance);
    }
    std::string operator()(const render::Sky& sky) const {
        return fmt::format("sky:elevation={},azimuth={},turbidity={}", sky.elevation / degree,
                           sky.azimuth / degree, sky.turbidity);
    }
};

}  // namespace

Options<LightRequest> light_options() {
    return {{custom_option<LightRequest>(
                 {.name = "--environment",
                  .others = {"--hdri", "--hdr", "--envmap", "--world"},
                  .placeholder = "FILE|COLOUR|sky",
                  .meaning =
                      "light from far away, for path: an equirectangular picture (.hdr, .exr, "
                      "...), a radiance or red,green,blue, or a sky such as "
                      "sky:elevation=30,azimuth=135,turbidity=3 (degrees; azimuth clockwise from "
                      "north). Default for a scene without light: a soft sky, or in a closed room "
                      "a light at the eye; for one with suns alone: a soft sky as well",
                  .type = OptionType::file},
                 read_environment,
                 [](const LightRequest& light) {
                     std::string word = std::visit(EnvironmentWord{}, light.environment);
                     return word.empty() ? std::vector<std::string>{}
                                         : std::vector{std::move(word)};
                 }),
             option({.name = "--environment-rotation",
                     .placeholder = "DEGREES",
                     .meaning = "turns the environment counterclockwise about the vertical axis"},
                    any_degrees(), &LightRequest::rotation),
             option({.name = "--environment-strength",
                     .placeholder = "FACTOR",
                     .meaning = "factor for the radiance of the environment"},
                    number(0.0F, 1e30F, "give a factor of at least 0"), &LightRequest::strength),
             option({.name = "--sun-angle",
                     .placeholder = "DEGREES",
                     .meaning = "angular diameter of directional lights, for path; 0 gives sharp "
                                "shadows (default: that of the scene, or of the sun, 0.53)"},
                    maybe(degrees(0.0, 180.0)), &LightRequest::sun_angle),
             option({.name = "--emission-scale",
                     .placeholder = "FACTOR",
                     .meaning = "factor for materials that emit; 1 is as written (default: 683 in "
                                "files with lamps that Blender has exported, which writes lamps in "
                                "candela, but emission in watts)"},
                    maybe(number(0.0F, static_cast<float>(scene::max_quantity),
                                 "give a factor of at least 0")),
                    &LightRequest::emission_scale)}};
}

}  // namespace balcony::app
