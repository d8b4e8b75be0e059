// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <limits>

#include <fmt/format.h>

#include "balcony/picture_options.hpp"

namespace balcony::app {

Value<std::uint32_t> seed_value() {
    return converted<std::uint32_t>(
        count(0, std::numeric_limits<std::uint32_t>::max()),
        [](std::size_t number) { return static_cast<std::uint32_t>(number); },
        [](std::uint32_t number) { return std::size_t{number}; });
}

Options<Request> sampling_options() {
    std::vector<OptionChoice> filters;
    for (const render::PixelFilterInfo& row : render::pixel_filters()) {
        filters.push_back({std::string(row.name), std::string(row.meaning)});
    }
    using render::SamplingSettings;
    using render::Settings;
    return {
        {option({.name = "--samples",
                 .letter = "-s",
                 .others = {"--spp", "--rays-per-pixel"},
                 .placeholder = "COUNT",
                 .meaning = fmt::format("rays per pixel, with --noise at most (default: {}, with "
                                        "--noise {})",
                                        default_samples, default_max_samples)},
                maybe(count(1, 1'000'000)), &Request::samples),
         option({.name = "--noise",
                 .others = {"--noise-threshold"},
                 .placeholder = "LEVEL",
                 .meaning = "sample each pixel until its noise is below this level: 0.01 is hardly "
                            "visible, 0 gives all pixels the same number of samples"},
                number(0.0, 1.0, "give a level from 0 to 1, such as 0.01"), &Request::settings,
                &Settings::sampling, &SamplingSettings::noise),
         option({.name = "--seed",
                 .placeholder = "NUMBER",
                 .meaning = "another number gives another noise"},
                seed_value(), &Request::settings, &Settings::sampling, &SamplingSettings::seed),
         option({.name = "--filter",
                 .placeholder = "NAME",
                 .meaning = "weight of samples around a pixel: " + described(filters)},
                choice(filters), &Request::settings, &Settings::sampling,
                &SamplingSettings::filter)}};
}

}  // namespace balcony::app
