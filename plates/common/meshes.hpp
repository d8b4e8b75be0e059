// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Meshes that scenes of the plates are built of.

#include "balcony/scene.hpp"

namespace balcony::plates {

/// A cube about the origin whose edges are cut off at 45 degrees.
[[nodiscard]] scene::Mesh chamfered_cube(double size, double chamfer);

/// The side of a cylinder about the origin along an axis (0 is x, 1 is y, 2 is z), without caps.
[[nodiscard]] scene::Mesh cylinder(int axis, double length, double radius);

/// A rectangle in the xy plane about the origin that faces z, its texture upright along y and
/// repeated as often as stated.
[[nodiscard]] scene::Mesh rectangle(double width, double height, double repeat_x = 1.0,
                                    double repeat_y = 1.0);

/// A frame about such a rectangle: its moulding rises from the rectangle's edge and falls again to
/// the wall behind.
[[nodiscard]] scene::Mesh picture_frame(double width, double height, double moulding_width);

/// Adds the triangles of a part, which has the same attributes, to a mesh.
void append(scene::Mesh& mesh, const scene::Mesh& part);

}  // namespace balcony::plates
