// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Conformal maps of the sphere in a square, by elliptic integrals: Peirce's quincuncial map (1879)
// and Adams' world in a square (1929). With F(a) = the elliptic integral of the first kind for the
// modulus sqrt(1/2), whose values are PROJ's, a point of the map is (F(m), F(n)), and
//     s = sin m sqrt((1 + cos^2 n)/2),   t = sin n sqrt((1 + cos^2 m)/2),   1 - s^2 - t^2 = cos^2 m
//     cos^2 n
// are the coordinates of a point of the unit sphere.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "camera/maps/formula_maps.hpp"
#include "camera/maps/profile.hpp"

namespace balcony::camera::maps {

namespace {

using std::numbers::sqrt2;

// PROJ's integral is an odd polynomial, to which samples between the ends lead: by Newton's divided
// differences of F(a)/a in the square of a.
AngleFunctions::Function without_rounding(const AngleFunctions::Function& integral) {
    constexpr std::size_t samples = 9;
    std::array<double, samples> squares{};
    std::array<double, samples> differences{};
    for (std::size_t i = 0; i < samples; ++i) {
        const double a = 0.3 + 1.2 * static_cast<double>(i) / (samples - 1);
        squares[i] = a * a;
        differences[i] = integral(a) / a;
    }
    for (std::size_t order = 1; order < samples; ++order) {
        for (std::size_t i = samples - 1; i >= order; --i) {
            differences[i] =
                (differences[i] - differences[i - 1]) / (squares[i] - squares[i - order]);
        }
    }
    return [=](double a) {
        double quotient = 0.0;
        for (std::size_t i = samples; i-- > 0;) {
            quotient = quotient * (a * a - squares[i]) + differences[i];
        }
        return quotient * a;
    };
}

/// F and its inverse.
struct EllipticIntegral {
    Profile inverse;

    /// By the coordinate of the map at n = 0, which loses digits at both ends.
    static std::optional<EllipticIntegral> make(const AngleFunctions::Function& coordinate) {
        const AngleFunctions::Function integral = without_rounding(coordinate);
        std::optional<Profile> inverse = Profile::make({.coordinate = integral,
                                                        .second = [](double) { return 0.0; },
                                                        .parameters = {0.0, 0.5 * pi}});
        if (!inverse) {
            return std::nullopt;
        }
        return EllipticIntegral{std::move(*inverse)};
    }
    /// s, t and the root of 1 - s^2 - t^2.
    [[nodiscard]] ObjectPoint on_sphere(Expr x, Expr y, Emitter& emit) const {
        const Expr m = inverse(abs(x), emit).angle;
        const Expr n = inverse(abs(y), emit).angle;
        const Expr s = sign(x) * sin(m) * sqrt(0.5 + 0.5 * cos(n) * cos(n));
        const Expr t = sign(y) * sin(n) * sqrt(0.5 + 0.5 * cos(m) * cos(m));
        return {s, t, cos(m) * cos(n)};
    }
};

// The hemisphere of the half longitudes, whose latitude has the sine tan(phi/2).
InverseMapPointer adams_world(const Definition&, const ForwardMap& map) {
    const std::optional<EllipticIntegral> integral = EllipticIntegral::make([&map](double m) {
        const double sine = std::sin(m) / sqrt2;
        const double half = std::asin(std::min(1.0, sine / std::sqrt(1.0 - sine * sine)));
        const MapPoint p = map({2.0 * half, 2.0 * std::atan(sine)}).value_or(MapPoint{});
        return (p.x + p.y) / sqrt2;
    });
    if (!integral) {
        return nullptr;
    }
    return by_formula([integral = *integral](const ParameterPoint& p, Emitter& emit) {
        const auto [s, t, root] =
            integral.on_sphere((p.u + p.v) / sqrt2, (p.v - p.u) / sqrt2, emit);
        const Expr sine = (s + t) / sqrt2;
        const Expr longitude = 2.0 * atan2((s - t) / sqrt2, root);
        return at_longitude_and_latitude_of_map(longitude, 2.0 * atan(sine));
    });
}

// The northern hemisphere in a square, and the southern one in four triangles at its sides.
InverseMapPointer peirce_quincuncial(const Definition& definition, const ForwardMap& map) {
    const Definition::Entry* shape = definition.find("shape");
    const bool is_turned = shape != nullptr && shape->value == "square";
    if (shape != nullptr && !is_turned && shape->value != "diamond") {
        return nullptr;
    }
    const std::optional<EllipticIntegral> integral = EllipticIntegral::make([&](double m) {
        const MapPoint p = map({0.5 * pi, 0.5 * pi - m}).value_or(MapPoint{});
        return is_turned ? (p.x + p.y) / sqrt2 : p.x;
    });
    if (!integral) {
        return nullptr;
    }
    // Half of the way to the south pole, which PROJ has rounded.
    const auto distance = [&map](double latitude) {
        const MapPoint p = map({0.0, latitude}).value_or(MapPoint{});
        return std::hypot(p.x, p.y);
    };
    const double edge = 0.5 * (distance(0.5) + distance(-0.5));
    return by_formula(
        [integral = *integral, is_turned, edge](const ParameterPoint& p, Emitter& emit) {
            const Expr u = is_turned ? (p.u + p.v) / sqrt2 : p.u;
            const Expr v = is_turned ? (p.v - p.u) / sqrt2 : p.v;
            emit.require(abs(u) + abs(v) <= emit(2.0 * edge));
            const auto folded = [edge](Expr a) {
                return select(edge < abs(a), sign(a) * (2.0 * edge - abs(a)), a);
            };
            const auto [s, t, root] = integral.on_sphere(folded(u), folded(v), emit);
            const Expr is_south = edge < abs(u) || edge < abs(v);
            return ObjectPoint{-t, s, select(is_south, -root, root)};
        });
}

}  // namespace

std::vector<FormulaMapRow> elliptic_maps() {
    return {{"adams_ws2", adams_world}, {"peirce_q", peirce_quincuncial}};
}

}  // namespace balcony::camera::maps
