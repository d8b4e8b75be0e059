// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The superconics, for the objects that are made of them.

#include <string_view>
#include <vector>

#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

/// |x/a|^e + |y/b|^e = 1 with e = 2/gamma, in one of its parametrisations.
[[nodiscard]] Result<ObjectGeneratorPointer> superellipse(Scalar a, Scalar b, Scalar gamma,
                                                          std::string_view by);

/// The branch x > 0 of |x/a|^e - |y/b|^e = 1, in one of its parametrisations.
[[nodiscard]] Result<ObjectGeneratorPointer> superhyperbola(Scalar a, Scalar b, Scalar gamma,
                                                            std::string_view by);

inline std::vector<std::string_view> superellipse_parametrisations() {
    return {"angle_centre", "trigonometric", "arc_length"};
}

inline std::vector<std::string_view> superhyperbola_parametrisations() {
    return {"cartesian", "hyperbolic", "trigonometric", "angle_centre"};
}

/// The parameter that is 2/e.
[[nodiscard]] StageParameter gamma_parameter(std::string_view name, std::string_view meaning);

}  // namespace balcony::camera
