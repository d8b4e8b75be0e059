// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Views of the sphere from a point outside: from a satellite, and on a tilted plane (Snyder, "Map
// Projections: A Working Manual", 1987, section 23).

#include <cmath>
#include <numbers>

#include "camera/maps/formula_maps.hpp"

namespace balcony::camera::maps {

namespace {

/// The nearer point at which a ray from (1 + height, 0, 0) meets the unit sphere.
ObjectPoint met_sphere(double height, const ObjectVector& d, Emitter& emit) {
    const double distance = 1.0 + height;
    const Expr a = dot(d, d);
    const Expr b = distance * d.x;
    const Expr c = emit(distance * distance - 1.0);
    const Expr discriminant = b * b - a * c;
    emit.require(0.0 <= discriminant && d.x < 0.0);
    const Expr reach = c / (sqrt(max(discriminant, emit(0.0))) - b);
    return {distance + reach * d.x, reach * d.y, reach * d.z};
}

// The scanning angles of a satellite above the equator, times its height.
InverseMapPointer geostationary(const Definition& definition, const ForwardMap&) {
    const double height = definition.number("h", 1.0);
    const Definition::Entry* sweep = definition.find("sweep");
    const bool sweeps_x = sweep != nullptr && sweep->value == "x";
    return by_formula([=](const ParameterPoint& p, Emitter& emit) {
        const Expr x = tan(p.u / height);
        const Expr y = tan(p.v / height);
        emit.require(abs(p.u) < 0.5 * pi * height && abs(p.v) < 0.5 * pi * height);
        return met_sphere(height,
                          sweeps_x ? ObjectVector{emit(-1.0), x * sqrt(1.0 + y * y), y}
                                   : ObjectVector{emit(-1.0), x, y * sqrt(1.0 + x * x)},
                          emit);
    });
}

// The picture plane is tilted about the point where the line to the sphere's centre meets it.
InverseMapPointer tilted_perspective(const Definition& definition, const ForwardMap&) {
    const double height = definition.number("h", 1.0);
    const double tilt = definition.angle("tilt", 0.0);
    const double azimuth = definition.angle("azi", 0.0);
    const SpherePoint below{0.0, definition.angle("lat_0", 0.0)};
    const double c = std::cos(azimuth);
    const double s = std::sin(azimuth);
    auto map = by_formula([=](const ParameterPoint& p, Emitter& emit) {
        // In the plane that touches the sphere below the viewer.
        const Expr k = height / (height - std::sin(tilt) * p.v);
        emit.require(0.0 < k);
        const Expr across = k * p.u;
        const Expr along = k * std::cos(tilt) * p.v;
        return met_sphere(height, {emit(-height), c * across + s * along, c * along - s * across},
                          emit);
    });
    return in_axes(along_great_circle(below, 0.5 * pi), std::move(map));
}

}  // namespace

std::vector<FormulaMapRow> perspective_maps() {
    return {{"geos", geostationary}, {"tpers", tilted_perspective}};
}

}  // namespace balcony::camera::maps
