// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/sampling_options.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "cli/options/option_values.hpp"

namespace balcony::cli {

using app::default_max_samples;
using app::default_samples;

void add_sampling_options(CLI::App& command, SamplingWords& words) {
    command
        .add_option("-s,--samples", words.samples,
                    fmt::format("rays per pixel, with --noise at most (default: {}, with --noise "
                                "{})",
                                default_samples, default_max_samples))
        ->type_name("COUNT");
    command
        .add_option("--noise", words.noise,
                    "sample each pixel until its noise is below this level: 0.01 is hardly "
                    "visible, 0 gives all pixels the same number of samples")
        ->type_name("LEVEL")
        ->capture_default_str();
    command.add_option("--seed", words.seed, "another number gives another noise")
        ->type_name("NUMBER")
        ->capture_default_str();
    std::vector<std::string> filters;
    for (const render::PixelFilterInfo& row : render::pixel_filters()) {
        filters.push_back(fmt::format("{} ({})", row.name, row.meaning));
    }
    command
        .add_option("--filter", words.filter,
                    fmt::format("weight of samples around a pixel: {}", fmt::join(filters, " or ")))
        ->type_name("NAME")
        ->capture_default_str();
}

void read_sampling(const SamplingWords& words, app::Request& request, Diagnostics& diagnostics) {
    render::Settings& settings = request.settings;
    settings.sampling.noise = read_number("--noise", words.noise, 0.0, 1.0,
                                          "give a level from 0 to 1, such as 0.01", diagnostics);
    if (!words.samples.empty()) {
        request.samples = read_count("--samples", words.samples, 1, 1'000'000, diagnostics);
    }
    settings.sampling.seed = static_cast<std::uint32_t>(read_count(
        "--seed", words.seed, 0, std::numeric_limits<std::uint32_t>::max(), diagnostics));
    std::vector<std::string> filters;
    for (const render::PixelFilterInfo& row : render::pixel_filters()) {
        filters.emplace_back(row.name);
    }
    check_name("--filter", words.filter, filters, diagnostics);
    settings.sampling.filter = words.filter;
}

}  // namespace balcony::cli
