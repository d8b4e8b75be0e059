// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "balcony/inverse.hpp"

namespace balcony::cli {

/// A request to locate points.
struct PointSearch {
    const camera::Picture& picture;
    double width = 0.0;
    double height = 0.0;
    double time = 0.0;
    Axes axes = Axes::z_up;  ///< Of the points.
    std::span<const analyse::V3d> points;
};

/// "y up" or "z up".
[[nodiscard]] std::string_view axes_text(Axes axes);

/// Why none of the points is in the picture, if that is known: they would be in it with the other
/// axes, or they all lie behind the camera.
[[nodiscard]] Diagnostics explain_unseen(const PointSearch& search);

}  // namespace balcony::cli
