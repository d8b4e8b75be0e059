// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Maps of the whole sphere in an oval or a circle: maps of a part of it, whose longitudes are
// stretched (Snyder, "Map Projections: A Working Manual", 1987).

#include <cmath>
#include <numbers>

#include "camera/maps/formula_maps.hpp"

namespace balcony::camera::maps {

namespace {

/// A direction whose longitude is divided by a factor, of which |longitude| <= pi is on the map.
ObjectPoint stretched(const ObjectPoint& e, double factor, Emitter& emit) {
    const Expr longitude = atan2(e.y, e.x);
    emit.require(abs(longitude) <= emit(pi * factor));
    const Expr from_axis = sqrt(e.x * e.x + e.y * e.y);
    return {from_axis * cos(longitude / factor), from_axis * sin(longitude / factor), e.z};
}

// Lambert's azimuthal map of a hemisphere, with W times the longitude.
InverseMapPointer hammer(const Definition& definition, const ForwardMap&) {
    const double w = std::fabs(definition.number("W", 0.5));
    const double m = std::fabs(definition.number("M", 1.0));
    return by_formula([w, m](const ParameterPoint& p, Emitter& emit) {
        const Expr x = w / m * p.u;
        const Expr y = m * p.v;
        const Expr q = x * x + y * y;
        emit.require(q < 4.0);
        const Expr k = sqrt(1.0 - 0.25 * q);
        return stretched({1.0 - 0.5 * q, k * x, k * y}, w, emit);
    });
}

// The azimuthal equidistant map of a hemisphere, with half of the longitude.
InverseMapPointer aitoff(const Definition&, const ForwardMap&) {
    return by_formula([](const ParameterPoint& p, Emitter& emit) {
        constexpr double tiny = 1e-20;  // makes sin(angle)/angle equal 1 in the centre
        const Expr x = 0.5 * p.u;
        const Expr angle = sqrt(max(x * x + p.v * p.v, emit(tiny)));
        emit.require(angle < pi);
        const Expr k = sin(angle) / angle;
        return stretched({cos(angle), k * x, k * p.v}, 0.5, emit);
    });
}

// The stereographic map of a part of the sphere, with 1/W of longitude and of Mercator's y.
InverseMapPointer lagrange(const Definition& definition, const ForwardMap&) {
    const double w = definition.number("W", 2.0);
    const double middle = std::asinh(std::tan(definition.angle("lat_1", 0.0)));
    return by_formula([w, middle](const ParameterPoint& p, Emitter& emit) {
        const Expr q = p.u * p.u + p.v * p.v;
        const Expr sine = 4.0 * p.v / (4.0 + q);
        emit.require(abs(sine) < 1.0);
        const Expr longitude = w * atan2(4.0 * p.u, 4.0 - q);
        emit.require(abs(longitude) <= emit(pi));
        const Expr mercator_y = w * atanh(sine) + middle;
        const Expr cosine = 1.0 / cosh(mercator_y);
        return ObjectPoint{cosine * cos(longitude), cosine * sin(longitude), tanh(mercator_y)};
    });
}

// A heart: parallels are arcs about one centre, along which lengths are true.
InverseMapPointer bonne(const Definition& definition, const ForwardMap&) {
    const double standard = definition.angle("lat_1", 0.0);
    const double side = standard < 0.0 ? -1.0 : 1.0;
    const double center = std::cos(standard) / std::sin(standard);
    return by_formula([=](const ParameterPoint& p, Emitter& emit) {
        const Expr x = side * p.u;
        const Expr y = side * (center - p.v);
        const Expr distance = sqrt(x * x + y * y);
        const Expr latitude = center + standard - side * distance;
        const Expr longitude = side * distance * atan2(x, y) / cos(latitude);
        emit.require(abs(latitude) <= emit(0.5 * pi) && abs(longitude) <= emit(pi));
        return at_longitude_and_latitude_of_map(longitude, latitude);
    });
}

}  // namespace

std::vector<FormulaMapRow> stretched_maps() {
    return {{"bonne", bonne}, {"hammer", hammer}, {"aitoff", aitoff}, {"lagrng", lagrange}};
}

}  // namespace balcony::camera::maps
