// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "camera/lenses/lens_optics.hpp"

namespace balcony::camera {

/// What stops a ray on its way to the sensor.
struct Obstacle {
    enum class Kind : std::uint8_t { hole, miss, reflection };
    std::size_t surface = 0;
    Kind kind = Kind::hole;
};

/// Parallel light on its way to the sensor of a lens that is focused far away. It is traced as all
/// rays are, through the lens turned about the vertical line.
class LightBundle {
public:
    /// `field` are the tangents of where the light comes from: to the right of the axis and above.
    LightBundle(const LensOptics& lens, const std::array<double, 2>& field);

    /// Where the light from a point of the plane through the first vertex arrives on the sensor, in
    /// the axes of the field; nothing if it does not get there.
    [[nodiscard]] std::optional<std::array<double, 2>> arrival(
        const std::array<double, 2>& from) const;
    /// What stops it in the lens, without blades.
    [[nodiscard]] std::optional<Obstacle> obstacle(const std::array<double, 2>& from) const;
    /// The area across the light of a part of that plane.
    [[nodiscard]] double across(double area) const { return area * direction_[2]; }

private:
    LensOptics turned_;
    FocusedOptics<double> at_;  ///< Its sensor is the plane through the first vertex.
    double sensor_;
    std::array<double, 3> direction_;
};

}  // namespace balcony::camera
