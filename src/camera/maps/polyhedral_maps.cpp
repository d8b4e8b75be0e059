// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Maps of the sphere in squares: HEALPix in its two arrangements, and single faces of cubes.

#include <array>
#include <cmath>
#include <numbers>

#include "camera/maps/formula_maps.hpp"

namespace balcony::camera::maps {

namespace {

Expr within(Expr value, double first, double last, Emitter& emit) {
    return min(max(value, emit(first)), emit(last));
}

/// HEALPix (Calabretta and Roukema, "Mapping on the HEALPix grid", 2007): Lambert's cylindrical map
/// up to the latitudes with sine 2/3, and beyond them four triangles about the meridians of 45
/// degrees and its odd multiples, which Collignon's map fills.
ObjectPoint healpix_direction(const ParameterPoint& p, Emitter& emit) {
    emit.require(abs(p.u) <= emit(pi));
    const Expr is_polar = 0.25 * pi < abs(p.v);
    const Expr column = within(floor(2.0 / pi * p.u + 2.0), 0.0, 3.0, emit);
    const Expr middle = 0.5 * pi * column - 0.75 * pi;
    const Expr width = 2.0 - 4.0 / pi * abs(p.v);  // of the triangle, 1 at its base
    const Expr across = p.u - middle;
    emit.require(!is_polar || (0.0 < width && abs(across) <= 0.25 * pi * width));
    const Expr sine =
        select(is_polar, sign(p.v) * (1.0 - width * width / 3.0), 8.0 / (3.0 * pi) * p.v);
    // The cosine from 1 - sine, which is accurate near the poles.
    const Expr rest = select(is_polar, width * width / 3.0, 1.0 - abs(sine));
    const Expr cosine = sqrt(rest * (2.0 - rest));
    const Expr longitude =
        select(is_polar, middle + across / select(is_polar, width, emit(1.0)), p.u);
    return {cosine * cos(longitude), cosine * sin(longitude), sine};
}

InverseMapPointer healpix(const Definition& definition, const ForwardMap&) {
    const double angle = definition.angle("rot_xy", 0.0);
    return by_formula([angle](const ParameterPoint& p, Emitter& emit) {
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        return healpix_direction({c * p.u - s * p.v, c * p.v + s * p.u}, emit);
    });
}

/// rHEALPix (Gibb, Raichev and Speth, "The rHEALPix Discrete Global Grid System", 2013): the four
/// triangles of each pole together form a square above or below one of the columns.
InverseMapPointer rhealpix(const Definition& definition, const ForwardMap&) {
    const double north_column = definition.number("north_square", 0.0);
    const double south_column = definition.number("south_square", 0.0);
    return by_formula([=](const ParameterPoint& p, Emitter& emit) {
        const Expr is_polar = 0.25 * pi < abs(p.v);
        const Expr is_north = 0.0 <= p.v;
        const Expr column = select(is_north, emit(north_column), emit(south_column));
        // From the centre of the square; v away from the equator.
        const Expr u = p.u - (0.5 * pi * column - 0.75 * pi);
        const Expr v = abs(p.v) - 0.5 * pi;
        emit.require(!is_polar || (abs(u) <= emit(0.25 * pi) && abs(v) <= emit(0.25 * pi)));
        // Which of the four triangles: by quarter turns from the one next to the equator.
        const Expr is_near = v <= -abs(u);
        const Expr is_far = abs(u) <= v;
        const Expr is_right = 0.0 < u;
        const Expr turns = select(
            is_near, emit(0.0), select(is_far, emit(2.0), select(is_right, emit(1.0), emit(3.0))));
        const Expr across = select(is_near, u, select(is_far, -u, select(is_right, v, -v)));
        const Expr outwards = select(is_near, v, select(is_far, -v, select(is_right, -u, u)));
        const Expr from_column = mod(column + turns, emit(4.0));
        const Expr x = 0.5 * pi * from_column - 0.75 * pi + across;
        const Expr y = select(is_north, emit(1.0), emit(-1.0)) * (outwards + 0.5 * pi);
        return healpix_direction({select(is_polar, x, p.u), select(is_polar, y, p.v)}, emit);
    });
}

/// The axes of the face of a cube, with the face ahead: by lat_0, since longitudes are from lon_0.
SphereAxes face_axes(const Definition& definition) {
    return along_great_circle({0.0, definition.angle("lat_0", 0.0)}, 0.5 * pi);
}

/// The quadrilateralized spherical cube (O'Neill and Laubscher 1976; Calabretta and Greisen 2002):
/// a face of equal area.
InverseMapPointer quadrilateralized_cube(const Definition& definition, const ForwardMap&) {
    auto map = by_formula(
        [](const ParameterPoint& p, Emitter& emit) {
            emit.require(abs(p.u) <= emit(1.0) && abs(p.v) <= emit(1.0));
            // In the triangle to the right of the centre: |b| <= a.
            const Expr is_wide = abs(p.v) <= abs(p.u);
            const Expr a = max(abs(p.u), abs(p.v));
            const Expr b = select(is_wide, p.v, p.u) / max(a, emit(1e-12));
            const Expr angle = pi / 12.0 * b;
            const Expr slope = sin(angle) / (cos(angle) - std::numbers::sqrt2 / 2.0);
            // 1 - cos of the angle from the centre of the face.
            const Expr rest = a * a * (1.0 - 1.0 / sqrt(2.0 + slope * slope));
            const Expr from_axis = sqrt(rest * (2.0 - rest));
            const Expr along = from_axis / sqrt(1.0 + slope * slope);
            const Expr across = slope * along;
            return ObjectPoint{1.0 - rest, select(is_wide, sign(p.u) * along, across),
                               select(is_wide, across, sign(p.v) * along)};
        },
        MapExtent{-1.0, 1.0, -1.0, 1.0});
    return in_axes(face_axes(definition), std::move(map));
}

// The inverses of the S2 library's projections of a coordinate of a face, from 0 to 1, to -1 to 1.
Expr s2_linear(Expr s) { return 2.0 * s - 1.0; }
Expr s2_tangent(Expr s) { return tan(0.25 * pi * (2.0 * s - 1.0)); }
Expr s2_quadratic(Expr s) {
    const Expr from_end = 1.0 - s;
    return select(0.5 <= s, (4.0 * s * s - 1.0) / 3.0, (1.0 - 4.0 * from_end * from_end) / 3.0);
}

/// A face of the S2 library's cube (Google 2011).
InverseMapPointer s2_cube(const Definition& definition, const ForwardMap&) {
    const Definition::Entry* spacing = definition.find("UVtoST");
    const std::string name = spacing == nullptr ? "quadratic" : spacing->value;
    Expr (*const from_end_to_end)(Expr) = name == "linear"      ? s2_linear
                                          : name == "tangent"   ? s2_tangent
                                          : name == "quadratic" ? s2_quadratic
                                                                : nullptr;
    if (from_end_to_end == nullptr) {
        return nullptr;
    }
    // Each face ahead, along its u and along its v.
    struct Face {
        Direction ahead, u, v;
    };
    const double latitude = definition.angle("lat_0", 0.0);
    const double quarters = std::round(definition.angle("lon_0", 0.0) / (0.5 * pi));
    Face face{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (latitude > 0.25 * pi) {
        face = {{0, 0, 1}, {-1, 0, 0}, {0, -1, 0}};
    } else if (latitude < -0.25 * pi) {
        face = {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
    } else if (quarters == 1.0) {
        face = {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
    } else if (std::fabs(quarters) == 2.0) {
        face = {{-1, 0, 0}, {0, 0, -1}, {0, -1, 0}};
    } else if (quarters == -1.0) {
        face = {{0, -1, 0}, {0, 0, -1}, {1, 0, 0}};
    }
    auto map = by_formula(
        [=](const ParameterPoint& p, Emitter& emit) {
            emit.require(0.0 <= p.u && p.u <= emit(1.0) && 0.0 <= p.v && p.v <= emit(1.0));
            const Expr u = from_end_to_end(p.u);
            const Expr v = from_end_to_end(p.v);
            const Expr scale = 1.0 / sqrt(1.0 + u * u + v * v);
            return ObjectPoint{scale, scale * u, scale * v};
        },
        MapExtent{0.0, 1.0, 0.0, 1.0});
    return in_axes({face.ahead, face.u, face.v}, std::move(map));
}

}  // namespace

std::vector<FormulaMapRow> polyhedral_maps() {
    return {{"healpix", healpix},
            {"rhealpix", rhealpix},
            {"qsc", quadrilateralized_cube},
            {"s2", s2_cube}};
}

}  // namespace balcony::camera::maps
