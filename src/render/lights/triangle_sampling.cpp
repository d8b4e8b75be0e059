// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/lights/triangle_sampling.hpp"

#include <cmath>

namespace balcony::render {

namespace {

// From the unit square to a triangle with less distortion than the usual root: Heitz, "A
// Low-Distortion Map Between Triangle and Square" (2019).
Imath::V2f in_triangle(const Imath::V2f& square) {
    return square.y > square.x ? Imath::V2f(0.5F * square.x, square.y - 0.5F * square.x)
                               : Imath::V2f(square.x - 0.5F * square.y, 0.5F * square.y);
}

}  // namespace

std::optional<TriangleSample> sample_triangle(const WorldTriangle& triangle, const V3f& from,
                                              const Imath::V2f& random) {
    const Imath::V2f at = in_triangle(random);
    const V3f way = triangle.corner + at.x * triangle.edge_1 + at.y * triangle.edge_2 - from;
    const float distance = way.length();
    if (!(distance > 0.0F)) {
        return std::nullopt;
    }
    TriangleSample sample{way / distance, distance, at.x, at.y};
    sample.pdf = pdf_of_triangle(triangle, sample.direction, distance);
    return sample.pdf > 0.0F && std::isfinite(sample.pdf) ? std::optional(sample) : std::nullopt;
}

// Uniform by area: distance² / (cosine area), and across() is twice the area times the normal.
float pdf_of_triangle(const WorldTriangle& triangle, const V3f& direction, float distance) {
    return 2.0F * distance * distance / std::abs(triangle.across().dot(direction));
}

}  // namespace balcony::render
