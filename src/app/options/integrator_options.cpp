// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "app/options/word_parts.hpp"
#include "balcony/picture_options.hpp"

namespace balcony::app {

namespace {

using render::BounceLimits;
using render::PathSettings;
using render::Settings;

struct Limit {
    std::string_view name;
    std::size_t BounceLimits::*value;
};

constexpr Limit limits[]{
    {"all", &BounceLimits::all},
    {"diffuse", &BounceLimits::diffuse},
    {"glossy", &BounceLimits::glossy},
    {"transmission", &BounceLimits::transmission},
};

std::string word_of(const BounceLimits& bounces) {
    std::string word;
    for (const Limit& limit : limits) {
        word += fmt::format("{}{}={}", word.empty() ? "" : ",", limit.name, bounces.*limit.value);
    }
    return word;
}

// A number for all kinds, or a list such as diffuse=2,glossy=4.
void read_bounces(std::span<const std::string> words, Settings& settings, Diagnostics& found) {
    const std::string& word = words.back();
    const Value<std::size_t> number = count(0, BounceLimits::most);
    const auto read = [&](std::string_view part, std::size_t& value) {
        const auto made = number.read(part);
        if (made) {
            value = *made;
        } else {
            found.push_back(refused("--bounces", part, number.remedy(part)));
        }
    };
    if (word == "auto") {
        return;
    }
    if (word.find('=') == std::string::npos) {
        std::size_t all = 0;
        read(word, all);
        settings.path.bounces = {all, all, all, all};
        return;
    }
    for (const std::string_view part : parts_of(word, ",")) {
        const std::size_t equals = part.find('=');
        const auto* const limit =
            std::find_if(std::begin(limits), std::end(limits),
                         [&](const Limit& one) { return one.name == part.substr(0, equals); });
        if (limit == std::end(limits) || equals == std::string_view::npos) {
            found.push_back(refused(
                "--bounces", part,
                "write a number, or numbers by kind such as diffuse=2,glossy=4; the kinds are "
                "all, diffuse, glossy and transmission"));
            return;
        }
        read(part.substr(equals + 1), settings.path.bounces.*(limit->value));
    }
}

}  // namespace

Options<Settings> integrator_options() {
    std::vector<OptionChoice> integrators;
    for (const render::IntegratorInfo& row : render::integrators()) {
        integrators.push_back({std::string(row.name), std::string(row.meaning)});
    }
    const auto radiance =
        number(0.0F, std::numeric_limits<float>::max(), "give a number of at least 0");
    return {
        {option({.name = "--integrator",
                 .others = {"--preview=preview", "--draft=preview", "--engine", "--renderer"},
                 .placeholder = "NAME",
                 .meaning = described(integrators)},
                choice(integrators), &Settings::integrator),
         custom_option<Settings>(
             {.name = "--bounces",
              .others = {"--max-depth", "--depth"},
              .placeholder = "COUNT",
              .meaning = "how often light is scattered at most on its way from a lit surface to "
                         "the camera (path): a number, or numbers by kind; auto is " +
                         word_of(BounceLimits{})},
             read_bounces,
             [](const Settings& settings) {
                 const std::string word = word_of(settings.path.bounces);
                 return std::vector{word == word_of(BounceLimits{}) ? "auto" : word};
             }),
         option(
             {.name = "--clamp",
              .placeholder = "RADIANCE",
              .meaning = "the largest indirect light of a sample (path), where rare light is not "
                         "limited to less anyway; 0 is no such limit"},
             radiance, &Settings::path, &PathSettings::clamp_indirect),
         flag({.name = "--exact",
               .others = {"--unbiased", "--no-filter-glossy"},
               .meaning = "do not blur mirrors and glass that are seen by scattered light, and do "
                          "not limit rare indirect light (path): sharp caustics, which appear as "
                          "bright specks until many samples are taken"},
              true, &Settings::path, &PathSettings::exact),
         flag({.name = "--no-path-reuse",
               .meaning = "neighbouring pixels do not share the light that their paths find "
                          "(path): more noise, but each pixel is independent of the others"},
              false, &Settings::path, &PathSettings::reuse)}};
}

}  // namespace balcony::app
