// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Maps whose inverse is found by Newton's method in the formulas, from a close guess.

#include <array>
#include <cmath>
#include <numbers>

#include "camera/maps/formula_maps.hpp"

namespace balcony::camera::maps {

namespace {

/// A longitude and a latitude.
struct SphereExpr {
    Expr longitude, latitude;
};
using ForwardFormula = std::function<ParameterPoint(const SphereExpr& point)>;

using Guess = std::function<SphereExpr(const ParameterPoint& p, Emitter& emit)>;

InverseMapPointer by_newton(ForwardFormula forward, Guess guess) {
    return by_formula([=](const ParameterPoint& p, Emitter& emit) {
        Graph& graph = emit.graph();
        const Expr a = graph.fresh_variable();
        const Expr b = graph.fresh_variable();
        const ParameterPoint image = forward({a, b});
        const std::array xy{image.u, image.v};
        std::vector<Expr> formulas(xy.begin(), xy.end());
        for (const Expr variable : {a, b}) {
            const std::vector<Expr> slopes = expr::differentiate(xy, variable);
            formulas.insert(formulas.end(), slopes.begin(), slopes.end());
        }
        const auto at = [&](const SphereExpr& point) {
            const std::array values{expr::Substitution{a, point.longitude},
                                    expr::Substitution{b, point.latitude}};
            return expr::substitute(graph, formulas, values);
        };
        SphereExpr found = guess(p, emit);
        constexpr int steps = 5;
        for (int step = 0; step < steps; ++step) {
            const std::vector<Expr> f = at(found);
            const Expr miss_x = f[0] - p.u;
            const Expr miss_y = f[1] - p.v;
            const Expr determinant = f[2] * f[5] - f[4] * f[3];
            found = {found.longitude - (f[5] * miss_x - f[4] * miss_y) / determinant,
                     found.latitude - (f[2] * miss_y - f[3] * miss_x) / determinant};
        }
        const std::vector<Expr> f = at(found);
        constexpr double doubt = 1e-10;
        emit.require(abs(f[0] - p.u) <= emit(doubt) && abs(f[1] - p.v) <= emit(doubt));
        emit.require(abs(found.longitude) <= emit(pi) && abs(found.latitude) <= emit(0.5 * pi));
        return at_longitude_and_latitude_of_map(found.longitude, found.latitude);
    });
}

// The mean of Aitoff's map and the equirectangular one.
InverseMapPointer winkel_tripel(const Definition& definition, const ForwardMap&) {
    const double cosine =
        definition.has("lat_1") ? std::cos(definition.angle("lat_1", 0.0)) : 2.0 / pi;
    const auto forward = [cosine](const SphereExpr& point) {
        constexpr double tiny = 1e-20;
        const Expr x = cos(point.latitude) * sin(0.5 * point.longitude);
        const Expr y = sin(point.latitude);
        const Expr from_center = sqrt(max(x * x + y * y, x.graph().constant(tiny)));
        const Expr ratio =
            atan2(from_center, cos(point.latitude) * cos(0.5 * point.longitude)) / from_center;
        return ParameterPoint{0.5 * (2.0 * ratio * x + cosine * point.longitude),
                              0.5 * (ratio * y + point.latitude)};
    };
    return by_newton(forward, [cosine](const ParameterPoint& p, Emitter&) {
        return SphereExpr{2.0 * p.u / (cos(p.v) + cosine), p.v};
    });
}

/// The American polyconic map: a parallel is an arc of the radius cot(phi) about (0, phi +
/// cot(phi)), along which lengths are true. So (x^2 + (phi - y)^2) sin(phi) + 2 (phi - y) cos(phi)
/// = 0, which has one root between the equator and y or the pole.
InverseMapPointer polyconic(const Definition& definition, const ForwardMap&) {
    const double origin = definition.angle("lat_0", 0.0);
    return by_formula([origin](const ParameterPoint& p, Emitter& emit) {
        const Expr y = abs(p.v + origin);
        const auto miss = [&](Expr phi) {
            const Expr d = phi - y;
            return (p.u * p.u + d * d) * sin(phi) + 2.0 * d * cos(phi);
        };
        Expr low = emit(0.0);
        Expr high = min(y, emit(0.5 * pi));
        constexpr int halvings = 14;
        for (int i = 0; i < halvings; ++i) {
            const Expr middle = 0.5 * (low + high);
            const Expr is_low = miss(middle) < 0.0;
            low = select(is_low, middle, low);
            high = select(is_low, high, middle);
        }
        Expr phi = 0.5 * (low + high);
        constexpr int newton_steps = 3;
        for (int i = 0; i < newton_steps; ++i) {
            const Expr d = phi - y;
            const Expr slope = (p.u * p.u + d * d + 2.0) * cos(phi);
            phi = phi - miss(phi) / slope;
        }
        // The angle at the centre is lambda sin(phi).
        constexpr double tiny = 1e-20;
        const Expr across = max(abs(p.u) * sin(phi), emit(tiny));
        const Expr angle = atan2(across, (phi - y) * sin(phi) + cos(phi));
        const Expr longitude = p.u * angle / across;
        emit.require(abs(longitude) <= emit(pi) && phi <= emit(0.5 * pi));
        return at_longitude_and_latitude_of_map(longitude, sign(p.v + origin) * phi);
    });
}

/// Van der Grinten's first map: meridians are circles through the poles (0, 1) and (0, -1), in
/// units of pi, and parallels are circles that meet the y axis at t and the outline at t/(1 + t^2 -
/// t), where t is the tangent of half the angle with the sine 2 phi/pi.
InverseMapPointer van_der_grinten(const Definition&, const ForwardMap&) {
    return by_formula([](const ParameterPoint& p, Emitter& emit) {
        const Expr x = p.u / pi;
        const Expr y = abs(p.v) / pi;
        const Expr q = x * x + y * y;
        emit.require(q <= emit(1.0));
        const Expr rest = 1.0 - q;
        const Expr longitude = 2.0 * pi * x / (rest + sqrt(rest * rest + 4.0 * x * x));
        // y t^3 - q t^2 - t + y = 0, from t = y.
        constexpr int steps = 8;
        Expr t = y;
        for (int step = 0; step < steps; ++step) {
            t = t + (y + t * (t * (y * t - q) - 1.0)) / (1.0 + t * (2.0 * q - 3.0 * y * t));
        }
        const Expr latitude = sign(p.v) * pi * t / (1.0 + t * t);
        return at_longitude_and_latitude_of_map(longitude, latitude);
    });
}

}  // namespace

std::vector<FormulaMapRow> searched_maps() {
    return {{"wintri", winkel_tripel}, {"poly", polyconic}, {"vandg", van_der_grinten}};
}

}  // namespace balcony::camera::maps
