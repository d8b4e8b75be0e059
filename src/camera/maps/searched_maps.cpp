// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Maps whose inverse is found by Newton's method in the formulas, from a close guess.

#include <algorithm>
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

/// The longitude and latitude of a near point of a map, constant in cells of a rectangle around it.
class Guess {
public:
    explicit Guess(const ForwardMap& map) {
        struct Sample {
            SpherePoint at;
            MapPoint on_map;
        };
        std::vector<Sample> samples;
        constexpr int columns = 72;
        constexpr int rows = 36;
        double width = 0.0;
        double height = 0.0;
        for (int i = 0; i <= columns; ++i) {
            for (int j = 0; j <= rows; ++j) {
                const SpherePoint at{pi * (2.0 * i / columns - 1.0),
                                     pi * (static_cast<double>(j) / rows - 0.5)};
                if (const auto p = map(at)) {
                    samples.push_back({at, *p});
                    width = std::max(width, std::fabs(p->x));
                    height = std::max(height, std::fabs(p->y));
                }
            }
        }
        constexpr std::size_t cells = 32;
        const auto middle = [](double size, std::size_t cell) {
            return size * ((2.0 * static_cast<double>(cell) + 1.0) / cells - 1.0);
        };
        std::vector<double> longitudes;
        std::vector<double> latitudes;
        for (std::size_t row = 0; row < cells; ++row) {
            for (std::size_t column = 0; column < cells; ++column) {
                const MapPoint p{middle(width, column), middle(height, row)};
                const auto nearest = std::min_element(
                    samples.begin(), samples.end(), [&p](const Sample& a, const Sample& b) {
                        return squared_distance(a.on_map, p) < squared_distance(b.on_map, p);
                    });
                longitudes.push_back(nearest->at.longitude);
                latitudes.push_back(nearest->at.latitude);
            }
        }
        const std::vector<expr::Table::Axis> axes{{-height, height, cells, 0},
                                                  {-width, width, cells, 0}};
        longitude_ = std::make_shared<const expr::Table>(expr::Table{axes, std::move(longitudes)});
        latitude_ = std::make_shared<const expr::Table>(expr::Table{axes, std::move(latitudes)});
    }

    [[nodiscard]] SphereExpr operator()(const ParameterPoint& p, Emitter& emit) const {
        const std::array at{p.v, p.u};
        return {emit.graph().lookup(longitude_, at), emit.graph().lookup(latitude_, at)};
    }

private:
    static double squared_distance(const MapPoint& a, const MapPoint& b) {
        return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
    }

    std::shared_ptr<const expr::Table> longitude_, latitude_;
};

constexpr int newton_steps = 6;

InverseMapPointer by_newton(const ForwardMap& map, ForwardFormula forward) {
    return by_formula(
        [guess = Guess(map), forward = std::move(forward)](const ParameterPoint& p, Emitter& emit) {
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
            for (int step = 0; step < newton_steps; ++step) {
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

/// sin(a)/a by the square of a.
Expr sine_quotient(Expr square) {
    constexpr double tiny = 1e-20;  // makes it 1 at 0
    const Expr a = sqrt(max(square, square.graph().constant(tiny)));
    return sin(a) / a;
}

// The mean of Aitoff's map and the equirectangular one.
InverseMapPointer winkel_tripel(const Definition& definition, const ForwardMap& map) {
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
    return by_newton(map, forward);
}

// The American polyconic map: each parallel is the one of the cone that touches the sphere there.
InverseMapPointer polyconic(const Definition& definition, const ForwardMap& map) {
    const double origin = definition.angle("lat_0", 0.0);
    const auto forward = [origin](const SphereExpr& point) {
        const Expr angle = point.longitude * sin(point.latitude);
        const Expr half = sine_quotient(0.25 * angle * angle);
        return ParameterPoint{
            point.longitude * cos(point.latitude) * sine_quotient(angle * angle),
            point.latitude - origin +
                0.5 * point.longitude * angle * cos(point.latitude) * half * half};
    };
    return by_newton(map, forward);
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
