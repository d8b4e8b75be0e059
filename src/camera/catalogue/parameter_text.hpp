// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Parameters and their values in messages, as a user writes them.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/catalogue.hpp"

namespace balcony::camera {

/// A number with its unit.
[[nodiscard]] std::string number_text(double value, Unit unit);
/// "from 1 to 20", "above 0".
[[nodiscard]] std::string range_text(const Range& range, Unit unit);
/// 2 or 3; 1, 2 or 3.
[[nodiscard]] std::string counts_text(const std::vector<std::size_t>& counts);
/// [0, 1, 2] or [(0, 0), (1, 1), (2, 2)], as long as the parameter needs but no longer than 3.
[[nodiscard]] std::string example_of(const PointsParameter& type);
/// The purpose of the parameter, and its default.
[[nodiscard]] std::string purpose(const StageParameter& parameter,
                                  std::optional<double> default_value, Unit unit);
/// How the numbers of a parameter are written that are given in another form.
[[nodiscard]] std::string form_remedy(const StageParameter& parameter);
/// The word for a stage that the parameter takes: "curve", "direction rule".
[[nodiscard]] std::string_view noun_of(const NestedStageParameter& type);
/// "point", "curve" or "surface".
[[nodiscard]] std::string_view object_noun(int dimension);
/// "write a direction rule such as normal(side)".
[[nodiscard]] std::string stage_remedy(const NestedStageParameter& type);

[[nodiscard]] inline bool contains(const Range& range, double value) {
    const bool above = range.excludes_minimum ? value > range.minimum : value >= range.minimum;
    return above && value <= range.maximum;
}

[[nodiscard]] inline bool is_numbers(const PointsParameter& type) {
    return type.coordinates.size() == 1 && type.coordinates.front() == 1;
}

/// The unit vector of x, y, z, -x, -y or -z.
[[nodiscard]] std::optional<std::array<double, 3>> named_axis(std::string_view word);

}  // namespace balcony::camera
