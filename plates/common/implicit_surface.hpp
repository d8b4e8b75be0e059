// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Bodies that are given by a function of space.

#include <functional>

#include <Imath/ImathBox.h>

#include "balcony/scene.hpp"

namespace balcony::plates {

/// Negative inside a body, positive outside. Near the surface, about the distance from it.
using Field = std::function<double(const scene::V3d&)>;

/// The surface where a field is 0, within a box that it does not leave, from cubic cells of a size
/// (surface nets: S. Gibson, 1998). Its vertices lie on the surface, and its normals are those of
/// the field, which is called from several threads. The field must not grow or fall by more than
/// `steepness` for each unit of length.
[[nodiscard]] scene::Mesh implicit_surface(const Field& field, const Imath::Box3d& box, double cell,
                                           double steepness = 1.5);

/// The smaller of two distances, with a round transition where they differ by less than `width`.
[[nodiscard]] double smooth_min(double a, double b, double width);

}  // namespace balcony::plates
