// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How many samples a picture has, and where they lie.

#include <string>

#include "balcony/request.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

/// The words of --samples, --noise, --seed and --filter.
struct SamplingWords {
    std::string samples;  ///< Depends on the noise level if empty.
    std::string noise = "0";
    std::string seed = "0";
    std::string filter = render::SamplingSettings{}.filter;
};

void add_sampling_options(CLI::App& command, SamplingWords& words);

/// Sets the number of samples and the sampling settings.
void read_sampling(const SamplingWords& words, app::Request& request, Diagnostics& diagnostics);

}  // namespace balcony::cli
