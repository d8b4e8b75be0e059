// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Cameras that are placed by the size of the scene.

#include <string>

#include "cli/command_line.hpp"

namespace balcony::cli {

/// The words of --fit and --fit-to.
struct FitWords {
    bool fit = false;
    std::string object;
};

void add_fit_options(CLI::App& command, FitWords& words);

}  // namespace balcony::cli
