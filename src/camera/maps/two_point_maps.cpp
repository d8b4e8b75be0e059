// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Maps about two points or two axes: true distances from two points, and equal areas in an oval.

#include <cmath>
#include <numbers>

#include "camera/maps/formula_maps.hpp"

namespace balcony::camera::maps {

namespace {

Expr length_of(Expr x, Expr y) { return sqrt(x * x + y * y); }

// The distances from two points on the x axis of the map are those on the sphere.
InverseMapPointer two_point_equidistant(const Definition& definition, const ForwardMap& map) {
    const SpherePoint first{definition.angle("lon_1", 0.0), definition.angle("lat_1", 0.0)};
    const SpherePoint second{definition.angle("lon_2", 0.0), definition.angle("lat_2", 0.0)};
    const auto at_first = map(first);
    const auto at_second = map(second);
    if (!at_first || !at_second) {
        return nullptr;
    }
    const double half = 0.5 * std::fabs(at_second->x - at_first->x);
    const SphereAxes axes = through_points(first, second);
    return in_axes(
        axes, by_formula([half](const ParameterPoint& p, Emitter& emit) {
            // The distances a and b and the distance 2 half between the points are the sides of a
            // spherical triangle; the sine of its height times the sine of its base is
            // 2 sqrt(sin s sin(s - a) sin(s - b) sin(s - 2 half)), where differences that vanish on
            // the x axis are proportional to y squared.
            const Expr from_first = abs(p.u + half);
            const Expr from_second = abs(p.u - half);
            const Expr a = length_of(p.u + half, p.v);
            const Expr b = length_of(p.u - half, p.v);
            constexpr double tiny = 1e-300;
            const Expr excess_a = p.v * p.v / max(a + from_first, emit(tiny));
            const Expr excess_b = p.v * p.v / max(b + from_second, emit(tiny));
            const Expr s = 0.5 * (a + b) + half;
            const Expr minus_base = 0.5 * (excess_a + excess_b) + max(abs(p.u) - half, emit(0.0));
            const Expr minus_a =
                0.5 * (excess_b - excess_a) + min(max(half - p.u, emit(0.0)), emit(2.0 * half));
            const Expr minus_b =
                0.5 * (excess_a - excess_b) + min(max(half + p.u, emit(0.0)), emit(2.0 * half));
            const Expr product = sin(s) * sin(minus_a) * sin(minus_b) * sin(minus_base);
            emit.require(s <= emit(pi) && 0.0 <= product);
            const double sine = std::sin(2.0 * half);
            const double cosine = std::cos(2.0 * half);
            const Expr z = sign(p.v) * (2.0 / sine) * sqrt(max(product, emit(0.0)));
            return ObjectPoint{cos(a), (cos(b) - cosine * cos(a)) / sine, z};
        }));
}

// Snyder, "New equal-area map projections for noncircular regions" (1988).
InverseMapPointer oblated_equal_area(const Definition& definition, const ForwardMap&) {
    const double n = definition.number("n", 1.0);
    const double m = definition.number("m", 1.0);
    const double theta = definition.angle("theta", 0.0);
    auto map = by_formula([=](const ParameterPoint& p, Emitter& emit) {
        emit.require(abs(p.v) < n);
        const Expr along_y = 0.5 * n * asin(p.v / n);
        const Expr sine = p.u / m * cos(2.0 / n * along_y) / cos(along_y);
        emit.require(abs(sine) <= emit(1.0));
        const Expr along_x = 0.5 * m * asin(sine);
        // In Lambert's azimuthal map.
        const Expr x = 2.0 * sin(along_x);
        const Expr y = 2.0 * sin(along_y) * cos(2.0 / m * along_x) / cos(along_x);
        const Expr q = x * x + y * y;
        emit.require(q < 4.0);
        const Expr k = sqrt(1.0 - 0.25 * q);
        const double c = std::cos(theta);
        const double s = std::sin(theta);
        return ObjectPoint{1.0 - 0.5 * q, k * (c * x - s * y), k * (c * y + s * x)};
    });
    return in_axes(along_great_circle({0.0, definition.angle("lat_0", 0.0)}, 0.5 * pi),
                   std::move(map));
}

}  // namespace

std::vector<FormulaMapRow> two_point_maps() {
    return {{"tpeqd", two_point_equidistant}, {"oea", oblated_equal_area}};
}

}  // namespace balcony::camera::maps
