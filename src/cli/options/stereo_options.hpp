// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "balcony/request.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

/// The words of --stereo and what belongs to it; empty words are not given.
struct StereoWords {
    std::string format;
    std::string separation;
    std::string convergence;
    std::string baseline;
    std::string merge;
};

using app::StereoRequest;

void add_stereo_options(CLI::App& command, StereoWords& words);

/// What cannot be read is added to `diagnostics`.
[[nodiscard]] StereoRequest read_stereo(const StereoWords& words, Diagnostics& diagnostics);

}  // namespace balcony::cli
