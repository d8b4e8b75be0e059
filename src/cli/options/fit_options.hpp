// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Cameras that are placed by the size of the scene.

#include <string>
#include <vector>

#include "balcony/lang.hpp"
#include "balcony/scene.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

/// The words of --fit and --fit-to.
struct FitWords {
    bool fit = false;
    std::string object;

    [[nodiscard]] bool wanted() const { return fit || !object.empty(); }
};

void add_fit_options(CLI::App& command, FitWords& words);

/// Fits the cameras that a workspace makes to a scene, or to its object that --fit-to names.
[[nodiscard]] Diagnostics fit_cameras(const FitWords& words, const scene::Scene& scene,
                                      lang::Workspace& cameras);

/// An error if the last picture that the workspace made has no `fit` statement.
[[nodiscard]] Diagnostics check_fitted(const lang::Workspace& cameras);

/// What the `fit` statements of the last picture have set, as a line of a report; empty if there is
/// none.
[[nodiscard]] std::string fitted_text(const lang::Workspace& cameras);

}  // namespace balcony::cli
