// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "app/options/word_parts.hpp"
#include "balcony/picture_options.hpp"
#include "balcony/scene_edits.hpp"

namespace balcony::app {

namespace {

using scene::Light;
using scene::LightKind;

Value<Imath::Color3f> intensity() { return color(std::numeric_limits<float>::infinity(), {}); }

// The words of "spot 500 at 0,2,0 to 0,0,0 cone 30".
std::optional<Light> lamp_of(std::string_view text) {
    std::vector<std::string_view> words = parts_of(text, " ");
    std::erase(words, "");
    const auto kind = words.size() > 1 ? scene::light_kinds().find(words[0]) : std::nullopt;
    const auto strength = kind ? intensity().read(words[1]) : std::nullopt;
    if (!strength || words.size() % 2 != 0) {
        return std::nullopt;
    }
    Light lamp{.name = "lamp", .kind = *kind, .intensity = *strength};
    std::optional<Imath::V3d> target;
    for (std::size_t i = 2; i < words.size(); i += 2) {
        const auto point = point_of(words[i + 1]);
        if (words[i] == "at" && point) {
            lamp.position = *point;
        } else if (words[i] == "to" && point && lamp.kind != LightKind::point) {
            target = *point;
        } else if (words[i] == "cone" && lamp.kind == LightKind::spot) {
            const auto angle = degrees(0.1, 90.0).read(words[i + 1]);
            if (!angle) {
                return std::nullopt;
            }
            lamp.outer_cone = static_cast<float>(*angle);
        } else {
            return std::nullopt;
        }
    }
    if (target) {
        lamp.direction = *target - lamp.position;
    }
    const bool has_place = lamp.kind == LightKind::directional ||
                           std::find(words.begin(), words.end(), "at") != words.end();
    const bool has_way = lamp.kind == LightKind::point || target.has_value();
    if (!has_place || !has_way || !(lamp.direction.length() > 0.0)) {
        return std::nullopt;
    }
    lamp.direction.normalize();
    return lamp;
}

std::string word_of(const Light& lamp) {
    const auto point = [](const Imath::V3d& p) { return fmt::format("{},{},{}", p.x, p.y, p.z); };
    std::string word = fmt::format("{} {} at {}", scene::light_kinds()[lamp.kind].name,
                                   intensity().write(lamp.intensity), point(lamp.position));
    if (lamp.kind != LightKind::point) {
        word += fmt::format(" to {}", point(lamp.position + lamp.direction));
    }
    if (lamp.kind == LightKind::spot) {
        word += fmt::format(" cone {}", double{lamp.outer_cone} / degree);
    }
    return word;
}

void read_lamps(std::span<const std::string> words, LightRequest& light, Diagnostics& found) {
    for (const std::string& word : words) {
        if (const std::optional<Light> lamp = lamp_of(word)) {
            light.lamps.push_back(*lamp);
        } else {
            found.push_back(refused(
                "--lamp", word,
                "write for example 'point 100 at 1,2,3', 'spot 500 at 0,2,0 to 0,0,0 cone 30' or "
                "'sun 3 at 1,2,3 to 0,0,0'"));
        }
    }
}

}  // namespace

Options<LightRequest> lamp_options() {
    const auto exclusion = [](LightRequest&, const GivenWords& given, Diagnostics& found) {
        if (given.contains("--lamp-at-eye") &&
            (given.contains("--lamp") || given.contains("--environment"))) {
            found.push_back(error(Kind::usage,
                                  "--lamp-at-eye excludes --lamp and --environment, as it is the "
                                  "only light",
                                  "leave one out"));
        }
    };
    return {{custom_option<LightRequest>(
                 {.name = "--lamp",
                  .others = {"--light"},
                  .placeholder = "LAMP",
                  .meaning = "a lamp in the scene: 'point 100 at 1,2,3', 'spot 500 at 0,2,0 to "
                             "0,0,0 cone 30' or 'sun 3 at 1,2,3 to 0,0,0', with the intensity in "
                             "candela, or of a sun in lux, grey or red,green,blue; may be repeated",
                  .repeated = true},
                 read_lamps,
                 [](const LightRequest& light) {
                     std::vector<std::string> words;
                     for (const Light& lamp : light.lamps) {
                         words.push_back(word_of(lamp));
                     }
                     return words;
                 }),
             flag({.name = "--lamp-at-eye",
                   .others = {"--headlight", "--headlamp"},
                   .meaning = "light the scene from the eye alone"},
                  true, &LightRequest::lamp_at_eye)},
            {exclusion}};
}

}  // namespace balcony::app
