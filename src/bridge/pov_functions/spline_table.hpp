// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Tables in the language of POV-Ray, which has splines in the place of arrays: at its keys, a
// linear spline has exactly the numbers that it is given.

#include <string>
#include <string_view>

#include "bridge/text/listing.hpp"

namespace balcony::bridge {

/// Declares a function of the variables of a table that returns its value.
[[nodiscard]] std::string spline_table(const ListedTable& table,
                                       std::string (*number)(double value));

}  // namespace balcony::bridge
