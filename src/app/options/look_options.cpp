// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "balcony/picture_options.hpp"

namespace balcony::app {

namespace {

using render::Color3f;
using render::Settings;

constexpr std::string_view background_remedy =
    "write auto, transparent, black, white, a grey level such as 0.2, or red,green,blue";

Value<Color3f> background_color() {
    Value<Color3f> made =
        color(std::numeric_limits<float>::infinity(), std::string(background_remedy));
    made.read = [read = made.read](std::string_view word) {
        return word == "black"   ? std::optional(Color3f(0.0F))
               : word == "white" ? std::optional(Color3f(1.0F))
                                 : read(word);
    };
    return made;
}

void read_background(std::span<const std::string> words, Settings& settings, Diagnostics& found) {
    const std::string& word = words.back();
    settings.light.visible = word == "auto";
    settings.background = std::nullopt;
    if (word == "auto" || word == "transparent") {
        return;
    }
    settings.background = background_color().read(word);
    if (!settings.background) {
        found.push_back(refused("--background", word, std::string(background_remedy)));
    }
}

std::vector<std::string> write_background(const Settings& settings) {
    return {settings.background      ? background_color().write(*settings.background)
            : settings.light.visible ? "auto"
                                     : "transparent"};
}

Value<Color3f> ambient_radiance() {
    return converted<Color3f>(
        number(0.0F, std::numeric_limits<float>::max(), "give auto, or a number of at least 0"),
        [](float radiance) { return Color3f(radiance); },
        [](const Color3f& radiance) { return radiance.x; });
}

Value<std::optional<render::ViewTransform>> view_transform() {
    Value<std::optional<render::ViewTransform>> made = maybe(choice(render::view_transforms()));
    made.write = [](const std::optional<render::ViewTransform>& view) {
        return std::string(
            render::view_transforms()[view.value_or(render::ViewTransform::neutral)].name);
    };
    return made;
}

}  // namespace

Options<Request> look_options() {
    // More stops than between the smallest and the largest float would give 0 or infinity.
    constexpr double max_stops = 200.0;
    const auto stops = number(
        -max_stops, max_stops,
        fmt::format("give auto, or stops from -{0} to {0}, such as -1.5", max_stops), "stops");
    Options<Settings> background{{custom_option<Settings>(
        {.name = "--background",
         .others = {"--transparent=transparent", "--bg"},
         .placeholder = "COLOUR",
         .meaning = "transparent, black, white, a grey level, or red,green,blue (linear, from 0 "
                    "to 1), as the display shows it; auto shows the environment, if there is one",
         .type = OptionType::color,
         .choices = {{"auto"}, {"transparent"}, {"black"}, {"white"}}},
        read_background, write_background)}};
    Options<Request> made{
        {option({.name = "--exposure",
                 .others = {"--ev"},
                 .placeholder = "STOPS",
                 .meaning = "exposure in stops (PNG); auto changes pictures that would be nearly "
                            "black or white",
                 .effect = Effect::display},
                or_word("auto", stops), &Request::exposure),
         option({.name = "--view-transform",
                 .others = {"--tonemap", "--tone-mapping"},
                 .placeholder = "NAME",
                 .meaning = "from light to display colours (PNG): " +
                            described(choices_of(render::view_transforms())),
                 .effect = Effect::display},
                view_transform(), &Request::view),
         option({.name = "--ambient",
                 .placeholder = "RADIANCE",
                 .meaning = "light from all directions: with path an environment of this radiance, "
                            "with direct without shadows; auto follows the scene's lights with "
                            "direct"},
                or_word("auto", ambient_radiance()), &Request::settings, &Settings::ambient)}};
    made.add(&Request::settings, std::move(background));
    return made;
}

}  // namespace balcony::app
