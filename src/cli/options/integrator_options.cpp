// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/integrator_options.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "cli/options/option_values.hpp"

namespace balcony::cli {

namespace {

constexpr std::size_t max_bounces = 128;

struct Limit {
    std::string_view name;
    std::size_t render::BounceLimits::*value;
};

constexpr Limit limits[]{
    {"all", &render::BounceLimits::all},
    {"diffuse", &render::BounceLimits::diffuse},
    {"glossy", &render::BounceLimits::glossy},
    {"transmission", &render::BounceLimits::transmission},
};

// A number for all kinds, or a list such as diffuse=2,glossy=4.
void read_bounces(const std::string& text, render::BounceLimits& bounces,
                  Diagnostics& diagnostics) {
    if (text.find('=') == std::string::npos) {
        const std::size_t all = read_count("--bounces", text, 0, max_bounces, diagnostics);
        bounces = {all, all, all, all};
        return;
    }
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string part = text.substr(begin, end - begin);
        const std::size_t equals = part.find('=');
        const auto* const limit =
            std::find_if(std::begin(limits), std::end(limits),
                         [&](const Limit& one) { return one.name == part.substr(0, equals); });
        if (limit == std::end(limits) || equals == std::string::npos) {
            refuse(diagnostics, "--bounces", part,
                   "write a number, or numbers by kind such as diffuse=2,glossy=4; the kinds are "
                   "all, diffuse, glossy and transmission");
            return;
        }
        bounces.*(limit->value) =
            read_count("--bounces", part.substr(equals + 1), 0, max_bounces, diagnostics);
        begin = end + 1;
    }
}

}  // namespace

void add_integrator_options(CLI::App& command, IntegratorWords& words) {
    std::vector<std::string> integrators;
    for (const render::IntegratorInfo& row : render::integrators()) {
        integrators.push_back(fmt::format("{} ({})", row.name, row.meaning));
    }
    command
        .add_option("--integrator", words.integrator,
                    fmt::format("{}", fmt::join(integrators, " or ")))
        ->type_name("NAME")
        ->capture_default_str();
    const render::BounceLimits defaults;
    command
        .add_option(
            "--bounces", words.bounces,
            fmt::format("how often light is scattered at most on its way from a lit "
                        "surface to the camera (path): a number, or numbers by kind; auto "
                        "is all={},diffuse={},glossy={},transmission={}",
                        defaults.all, defaults.diffuse, defaults.glossy, defaults.transmission))
        ->type_name("COUNT")
        ->capture_default_str();
    command
        .add_option("--clamp", words.clamp,
                    "the largest indirect light of a sample (path), against bright specks; 0 is no "
                    "limit")
        ->type_name("RADIANCE")
        ->capture_default_str();
    command.add_flag("--no-path-reuse", words.no_path_reuse,
                     "neighbouring pixels do not share the light that their paths find (path): "
                     "more noise, but each pixel is independent of the others");
}

void read_integrator(const IntegratorWords& words, render::Settings& settings,
                     Diagnostics& diagnostics) {
    std::vector<std::string> names;
    for (const render::IntegratorInfo& integrator : render::integrators()) {
        names.emplace_back(integrator.name);
    }
    check_name("--integrator", words.integrator, names, diagnostics);
    settings.integrator = words.integrator;
    if (words.bounces != "auto") {
        read_bounces(words.bounces, settings.path.bounces, diagnostics);
    }
    settings.path.clamp_indirect =
        read_number("--clamp", words.clamp, 0.0F, std::numeric_limits<float>::max(),
                    "give a number of at least 0", diagnostics);
    settings.path.reuse = !words.no_path_reuse;
}

}  // namespace balcony::cli
