// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/lights/triangle_sampling.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::render {

namespace {

using Imath::V2f;
using Imath::V3d;

// From the unit square to a triangle with less distortion than the usual root: Heitz, "A
// Low-Distortion Map Between Triangle and Square" (2019).
V2f in_triangle(const V2f& square) {
    return square.y > square.x ? V2f(0.5F * square.x, square.y - 0.5F * square.x)
                               : V2f(square.x - 0.5F * square.y, 0.5F * square.y);
}

// Uniform by area: distance² / (cosine area), and across() is twice the area times the normal.
float pdf_by_area(const WorldTriangle& triangle, const V3f& direction, float distance) {
    return 2.0F * distance * distance / std::abs(triangle.across().dot(direction));
}

// The component of v that is perpendicular to a unit vector, as a unit vector.
V3d perpendicular(const V3d& v, const V3d& to) { return (v - v.dot(to) * to).normalized(); }

// A triangle that looks large, projected to the unit sphere around a point.
class SphericalTriangle {
public:
    // Nothing if the triangle looks small, so that sampling by area is almost as good, and quicker;
    // or if the angles between its sides are not precise, edge-on or from close by.
    static std::optional<SphericalTriangle> of(const WorldTriangle& triangle, const V3f& from) {
        constexpr float small = 2.0F;  // The square of an edge over that of the distance.
        constexpr double min_solid_angle = 1e-3;
        constexpr double max_solid_angle = 6.2;
        const V3f a = triangle.corner - from;
        const V3f center = a + (triangle.edge_1 + triangle.edge_2) / 3.0F;
        const float size2 = std::max({triangle.edge_1.length2(), triangle.edge_2.length2(),
                                      (triangle.edge_1 - triangle.edge_2).length2()});
        if (size2 < small * center.length2()) {
            return std::nullopt;
        }
        const SphericalTriangle made(V3d(a), V3d(a + triangle.edge_1), V3d(a + triangle.edge_2));
        return made.solid_angle_ >= min_solid_angle && made.solid_angle_ <= max_solid_angle
                   ? std::optional(made)
                   : std::nullopt;
    }

    [[nodiscard]] double solid_angle() const { return solid_angle_; }

    // Arvo, "Stratified Sampling of Spherical Triangles" (1995), with his names.
    [[nodiscard]] V3d sample(const V2f& random) const {
        const double length = a_.length();
        const V3d a = a_ / length;
        const V3d b = b_.normalized();
        const V3d across = a_.cross(b_);
        const V3d beyond = a_.cross(c_);
        const double lengths = std::sqrt(across.length2() * beyond.length2());
        const double cos_alpha = across.dot(beyond) / lengths;
        // The cross product of the two is the volume times a_.
        const double sin_alpha = volume_ * length / lengths;
        const double part = double{random.x} * solid_angle_;
        const double s = std::sin(part) * cos_alpha - std::cos(part) * sin_alpha;
        const double t = std::cos(part) * cos_alpha + std::sin(part) * sin_alpha;
        const double u = t - cos_alpha;
        const double v = s + sin_alpha * a.dot(b);
        const double below = (v * s + u * t) * sin_alpha;
        const double q = below != 0.0 ? ((v * t - u * s) * cos_alpha - v) / below : 1.0;
        const double cos_b = std::clamp(q, -1.0, 1.0);
        const V3d c = cos_b * a + std::sqrt(1.0 - cos_b * cos_b) * perpendicular(c_, a);
        const double z = 1.0 - double{random.y} * (1.0 - c.dot(b));
        return z * b + std::sqrt(std::max(0.0, 1.0 - z * z)) * perpendicular(c, b);
    }

private:
    // The solid angle after van Oosterom and Strackee (1983).
    SphericalTriangle(const V3d& a, const V3d& b, const V3d& c)
        : a_(a), b_(b), c_(c), volume_(std::abs(a.dot(b.cross(c)))) {
        const double p = a.length();
        const double q = b.length();
        const double r = c.length();
        solid_angle_ =
            2.0 * std::atan2(volume_, p * q * r + a.dot(b) * r + b.dot(c) * p + c.dot(a) * q);
    }

    V3d a_, b_, c_;  // Of any length.
    double volume_;  // Of the parallelepiped that they span.
    double solid_angle_ = 0.0;
};

// Where a direction meets the triangle: Möller and Trumbore, "Fast, Minimum Storage Ray-Triangle
// Intersection" (1997).
TriangleSample meeting(const WorldTriangle& triangle, const V3f& from, const V3f& direction) {
    const V3f p = direction.cross(triangle.edge_2);
    const V3f t = from - triangle.corner;
    const V3f q = t.cross(triangle.edge_1);
    const float determinant = triangle.edge_1.dot(p);
    const float u = std::clamp(t.dot(p) / determinant, 0.0F, 1.0F);
    const float v = std::clamp(direction.dot(q) / determinant, 0.0F, 1.0F - u);
    return {direction, triangle.edge_2.dot(q) / determinant, u, v};
}

std::optional<TriangleSample> usable(const TriangleSample& sample) {
    const bool is_usable = sample.pdf > 0.0F && std::isfinite(sample.pdf) &&
                           sample.distance > 0.0F && std::isfinite(sample.distance);
    return is_usable ? std::optional(sample) : std::nullopt;
}

}  // namespace

std::optional<TriangleSample> sample_triangle(const WorldTriangle& triangle, const V3f& from,
                                              const V2f& random) {
    if (const auto sphere = SphericalTriangle::of(triangle, from)) {
        const V3f direction(sphere->sample(random));
        TriangleSample sample = meeting(triangle, from, direction.normalized());
        sample.pdf = static_cast<float>(1.0 / sphere->solid_angle());
        return usable(sample);
    }
    const V2f at = in_triangle(random);
    const V3f way = triangle.corner + at.x * triangle.edge_1 + at.y * triangle.edge_2 - from;
    const float distance = way.length();
    TriangleSample sample{way / distance, distance, at.x, at.y};
    sample.pdf = pdf_by_area(triangle, sample.direction, distance);
    return usable(sample);
}

float pdf_of_triangle(const WorldTriangle& triangle, const V3f& from, const V3f& direction,
                      float distance) {
    const auto sphere = SphericalTriangle::of(triangle, from);
    const float density = sphere ? static_cast<float>(1.0 / sphere->solid_angle())
                                 : pdf_by_area(triangle, direction, distance);
    return std::isfinite(density) ? density : 0.0F;
}

}  // namespace balcony::render
