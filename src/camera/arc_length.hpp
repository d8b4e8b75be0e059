// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

#include "balcony/expr.hpp"

namespace balcony::camera {

/// The curve parameter as a function of u in [0, u_last], where u is proportional to the length of
/// the curve that runs over [0, parameter_last] with the given positive speed |dC/dparameter|.
/// The error falls with the fourth power of the number of cells.
[[nodiscard]] expr::Table parameter_by_length(const std::function<double(double)>& speed,
                                              double parameter_last, double u_last,
                                              std::size_t cells);

}  // namespace balcony::camera
