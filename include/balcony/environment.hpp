// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Environment: light from infinitely far away. docs/lights.md describes it.

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>

#include <Imath/ImathColor.h>

#include "balcony/base.hpp"

namespace balcony::render {

/// The sky of the earth at sea level, over a grey ground: light that air and haze scatter.
struct Sky {
    double elevation = 0.7853981633974483;  ///< Of the sun, in radians from -0.35 to pi/2.
    /// Of the sun, in radians, clockwise from the north: the scene's y if z is up, otherwise -z.
    double azimuth = 2.356194490192345;
    /// The optical depth of air with haze over that of pure air, from 1 to 10: 2 is clear, 4 hazy.
    double turbidity = 2.0;
};

/// Radiance by direction. Immutable; copies share their data.
///
/// The vertical axis is that of the scene. The centre of a picture is in the direction of the
/// scene's x axis, as in Blender.
class Environment {
public:
    /// Reads an equirectangular picture: linear light from EXR, HDR or other files of floats, sRGB
    /// from the others. Pixels that are negative, infinite or not a number are replaced, with a
    /// warning that counts them. A stop is an error of Kind::interrupted.
    [[nodiscard]] static Result<Environment> load(const std::filesystem::path& file,
                                                  const std::stop_token& stop = {});
    /// The same radiance from everywhere.
    [[nodiscard]] static Environment constant(const Imath::Color3f& radiance);

    /// A clear sky with the sun, in cd/m². A sky out of range is an error.
    [[nodiscard]] static Result<Environment> sky(const Sky& sky);
    /// A soft sky without sun, bright at the zenith and at the horizon, above a grey ground. A
    /// white floor below it has radiance 1.
    [[nodiscard]] static Environment dome();

    /// Turned about the vertical axis, counterclockwise seen from above, in radians.
    [[nodiscard]] Environment rotated(double angle) const;
    /// With radiance multiplied by a factor of at least 0.
    [[nodiscard]] Environment scaled(float factor) const;

    /// Completes the sentence "The scene is lit by": "a constant environment".
    [[nodiscard]] const std::string& description() const;

    struct State;
    [[nodiscard]] const State& state() const { return *state_; }

private:
    explicit Environment(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

}  // namespace balcony::render
