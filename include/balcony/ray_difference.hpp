// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Ray difference: how far two rays are apart, in pixels. Bridges measure with it what a less exact
// form of a camera, such as single precision or a coarser grid, changes in the picture.

#include "balcony/rays.hpp"

namespace balcony::rays {

/// How far the other ray is from an exact ray, in pixels: by how much the picture point of the
/// exact ray must move to get the other ray, to first order and by least squares, and what remains,
/// in pixels too. Origins and directions count alike at a distance: a change of the origin by this
/// length is as much as one radian. With an infinite distance directions alone count. The exact ray
/// has its footprint; both are valid, with directions of unit length. Infinite where the footprint
/// is a point but the rays differ.
[[nodiscard]] double pixels_between(const Ray& exact, const Ray& other, double distance);

}  // namespace balcony::rays
