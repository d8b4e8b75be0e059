// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Ray difference: how far two rays are apart, in pixels. Bridges measure with it what a less exact
// form of a camera, such as single precision or a coarser grid, changes in the picture.

#include "balcony/rays.hpp"

namespace balcony::rays {

/// How far the other ray is from an exact ray, in pixels: by how much the picture point of the
/// exact ray must move so that its ray passes through the other ray's point at a distance from the
/// origin, to first order. An infinite distance compares directions. The exact ray has its
/// footprint; both are valid, with directions of unit length. Infinite where the footprint at this
/// distance is a point but the rays differ.
[[nodiscard]] double pixels_between(const Ray& exact, const Ray& other, double distance);

}  // namespace balcony::rays
