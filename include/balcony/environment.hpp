// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Environment: light from infinitely far away. docs/lights.md describes it.

#include <filesystem>
#include <memory>
#include <string>

#include <Imath/ImathColor.h>

#include "balcony/base.hpp"

namespace balcony::render {

/// Radiance by direction. Immutable; copies share their data.
///
/// The vertical axis is that of the scene. The centre of a picture is in the direction of the
/// scene's x axis, as in Blender.
class Environment {
public:
    /// Reads an equirectangular picture: linear light from EXR, HDR or other files of floats, sRGB
    /// from the others. Pixels that are negative, infinite or not a number are replaced, with a
    /// warning that counts them.
    [[nodiscard]] static Result<Environment> load(const std::filesystem::path& file);
    /// The same radiance from everywhere.
    [[nodiscard]] static Environment constant(const Imath::Color3f& radiance);

    /// Turned about the vertical axis, counterclockwise seen from above, in radians.
    [[nodiscard]] Environment rotated(double angle) const;
    /// With radiance multiplied by a factor of at least 0.
    [[nodiscard]] Environment scaled(float factor) const;

    struct State;
    [[nodiscard]] const State& state() const { return *state_; }

private:
    explicit Environment(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

}  // namespace balcony::render
