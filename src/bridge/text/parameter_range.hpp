// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "bridge/text/camera_formulas.hpp"

namespace balcony::bridge {

/// The values that a parameter may have.
struct ParameterRange {
    std::optional<double> minimum, maximum;
};

/// The range that the stages hold an open parameter in: the tightest limits of it in the formulas.
[[nodiscard]] ParameterRange range_of(const CameraFormulas& formulas, std::string_view input);

}  // namespace balcony::bridge
