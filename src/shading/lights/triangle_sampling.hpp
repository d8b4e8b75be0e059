// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <Imath/ImathVec.h>

#include "shading/lights/emissive_triangles.hpp"

namespace balcony::render {

/// A point of a triangle, seen from another point.
struct TriangleSample {
    V3f direction;          ///< Unit, to the triangle.
    float distance = 0.0F;  ///< To the triangle.
    float u = 0.0F;         ///< Of the point corner + u edge_1 + v edge_2.
    float v = 0.0F;
    float pdf = 0.0F;  ///< By solid angle.
};

/// A random point of a triangle: evenly by solid angle if the triangle looks large, otherwise by
/// area. Nothing if it is seen edge-on, or if the triangle is degenerate.
[[nodiscard]] std::optional<TriangleSample> sample_triangle(const WorldTriangle& triangle,
                                                            const V3f& from,
                                                            const Imath::V2f& random);

/// The density of sample_triangle() in a direction that meets the triangle at a distance.
[[nodiscard]] float pdf_of_triangle(const WorldTriangle& triangle, const V3f& from,
                                    const V3f& direction, float distance);

}  // namespace balcony::render
