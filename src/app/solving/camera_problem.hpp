// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What marks demand of the parameters of a camera.

#include <string>
#include <vector>

#include "balcony/solving.hpp"

namespace balcony::app {

/// The parameters that are to be found, of a camera with as many open as can be.
struct WantedParameters {
    std::vector<lang::OpenParameter> open;
    std::vector<lang::OpenParameter> closed;  ///< Numbers that a camera is made of anew.

    /// All of them, in the order of the unknowns.
    [[nodiscard]] std::vector<lang::OpenParameter> all() const;
};
[[nodiscard]] Result<WantedParameters> wanted_parameters(const Marks& marks,
                                                         const lang::OpenCamera& camera);

/// The problem of these unknowns, with its marks in the axes of a camera.
[[nodiscard]] Result<solve::Problem> problem_of(const Marks& marks, const WantedParameters& wanted,
                                                Axes axes);

}  // namespace balcony::app
