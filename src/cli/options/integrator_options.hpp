// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How the light along a ray is computed.

#include <string>

#include "balcony/render.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

/// The words of --integrator, --bounces, --clamp and --no-path-reuse.
struct IntegratorWords {
    std::string integrator = render::Settings{}.integrator;
    std::string bounces = "auto";
    std::string clamp = "0";
    bool no_path_reuse = false;
};

void add_integrator_options(CLI::App& command, IntegratorWords& words);

/// Sets the integrator and its limits.
void read_integrator(const IntegratorWords& words, render::Settings& settings,
                     Diagnostics& diagnostics);

}  // namespace balcony::cli
