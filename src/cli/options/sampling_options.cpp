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

void add_sampling_options(CLI::App& command, SamplingWords& words) {
    command.add_option("-s,--samples", words.samples, "rays per pixel")
        ->type_name("COUNT")
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

void read_sampling(const SamplingWords& words, render::Settings& settings,
                   Diagnostics& diagnostics) {
    settings.samples = read_count("--samples", words.samples, 1, 1'000'000, diagnostics);
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
