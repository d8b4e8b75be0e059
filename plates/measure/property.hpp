// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What each plate must show, as numbers with bounds.

#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "measure/studio.hpp"

namespace balcony::plates {

/// A measured number and the bounds that it must keep.
struct Measurement {
    template <class Number>
    requires std::is_arithmetic_v<Number> Measurement(
        std::string what_, Number value_,
        double at_least_ = -std::numeric_limits<double>::infinity(),
        double at_most_ = std::numeric_limits<double>::infinity())
        : what(std::move(what_)),
          value(static_cast<double>(value_)),
          at_least(at_least_),
          at_most(at_most_) {}

    std::string what;  ///< For a page: "pictures wholly visible".
    double value;
    double at_least;
    double at_most;

    [[nodiscard]] bool met() const { return value >= at_least && value <= at_most; }
};

using Measurements = std::vector<Measurement>;

/// The property of a plate. A plate's folder defines it in property.cpp.
struct Property {
    int plate = 0;
    /// Measures the plate's camera with values for some of its parameters.
    Measurements (*measure)(Studio&, const Overrides&) = nullptr;
    /// Parameters with each of which at least one measurement is outside its bounds.
    std::vector<Overrides> wrong;
};

/// Those of all plates, in their order.
[[nodiscard]] std::span<const Property> properties();

[[nodiscard]] bool all_met(const Measurements& measurements);

}  // namespace balcony::plates
