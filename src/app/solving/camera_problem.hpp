// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What marks demand of the parameters of a camera.

#include <string>
#include <vector>

#include "balcony/solving.hpp"

namespace balcony::app {

/// The names of the parameters that are to be found, of a camera with all of them open.
[[nodiscard]] Result<std::vector<std::string>> wanted_parameters(const Marks& marks,
                                                                 const lang::OpenCamera& camera);

/// The problem of a camera whose open parameters are the unknowns, with its marks in the axes of the
/// camera.
[[nodiscard]] Result<solve::Problem> problem_of(const Marks& marks, const lang::OpenCamera& camera);

}  // namespace balcony::app
