// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <Imath/ImathVec.h>

namespace balcony::render {

/// A point of a surface, with the unit normal there.
struct SurfaceSample {
    Imath::V3d position, normal;
};

/// The longest run of parts of a circle that are not covered.
struct CircleGap {
    std::size_t length = 0;  ///< In parts.
    std::size_t end = 0;     ///< The part after it; of the next turn if it is not below the count.
};
[[nodiscard]] CircleGap longest_gap(std::span<const bool> covered);

struct RevolutionFit {
    Imath::V3d axis;      ///< A unit vector, upwards.
    Imath::V3d point;     ///< On the axis.
    double radius = 0.0;  ///< The largest mean distance from the axis at a height.
};

/// The axis of the surface of revolution to which samples of equal areas, with z up, are nearest,
/// if it is near most of them. Parts that leave it, such as handles, count little. Inner and outer
/// walls have a profile each; the radius is that of the outer one, if there is one.
[[nodiscard]] std::optional<RevolutionFit> fit_revolution(std::span<const SurfaceSample> samples);

}  // namespace balcony::render
