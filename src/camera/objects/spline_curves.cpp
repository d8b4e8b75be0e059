// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS: curves from points. All of them run from u = 0 to u = 1; an open
// one is undefined outside, a closed one is periodic. A curve from points of two coordinates lies
// in the plane z = 0 and can be a factor of a spherical product.

#include <cmath>

#include <fmt/format.h>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/curves/spline_tables.hpp"

namespace balcony::camera {

namespace {

/// A piecewise polynomial for each coordinate, divided by another one if there are weights.
class SplineCurve final : public ObjectGenerator {
public:
    SplineCurve(CellPosition position, std::vector<TablePointer> coordinates, TablePointer weight)
        : position_(std::move(position)),
          coordinates_(std::move(coordinates)),
          weight_(std::move(weight)) {}
    int dimension() const override { return 1; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr at = position_(p.u, emit);
        const auto value = [&](const TablePointer& table) {
            const Expr sum = emit.graph().lookup(table, at);
            return weight_ ? sum / emit.graph().lookup(weight_, at) : sum;
        };
        return {value(coordinates_[0]), value(coordinates_[1]),
                coordinates_.size() > 2 ? value(coordinates_[2]) : emit(0.0)};
    }

private:
    CellPosition position_;
    std::vector<TablePointer> coordinates_;
    TablePointer weight_;
};

/// The cells of a curve and the polynomials of its coordinates in them.
struct Pieces {
    std::vector<double> breaks;
    std::size_t degree = 3;
    bool closed = false;
    std::vector<std::vector<double>> coordinates{};
    std::vector<double> weight{};  ///< Empty: all are 1.
};

StageResult curve_of(const Pieces& pieces) {
    if (std::optional<Diagnostic> fault = fault_of_breaks(pieces.breaks)) {
        return std::move(*fault);
    }
    const auto table = [&](const std::vector<double>& coefficients) {
        const std::array axes{cells_axis(pieces.breaks.size() - 1, pieces.degree)};
        return table_of(axes, coefficients);
    };
    std::vector<TablePointer> coordinates;
    for (const std::vector<double>& coefficients : pieces.coordinates) {
        coordinates.push_back(table(coefficients));
    }
    return made<SplineCurve>(CellPosition(pieces.breaks, pieces.closed), std::move(coordinates),
                             pieces.weight.empty() ? nullptr : table(pieces.weight));
}

StageResult curve_of(const Spline& spline, const PointList& points) {
    Pieces pieces{spline.breaks(), spline.degree(), spline.closed()};
    for (std::size_t k = 0; k < points.coordinates; ++k) {
        pieces.coordinates.push_back(spline.coefficients(coordinate(points, k)));
    }
    return curve_of(pieces);
}

// --------------------------------------------------------------------- interpolating curves

double distance(std::span<const double> a, std::span<const double> b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        sum += (b[k] - a[k]) * (b[k] - a[k]);
    }
    return std::sqrt(sum);
}

/// The parameters in [0, 1] at which a curve passes its points: in equal steps, in steps
/// proportional to the distances of the points, or to the square roots of these.
Result<std::vector<double>> places_of(const PointList& points, std::string_view spacing,
                                      bool closed) {
    const std::size_t steps = closed ? points.size() : points.size() - 1;
    std::vector<double> places{0.0};
    for (std::size_t i = 0; i < steps; ++i) {
        const std::size_t next = (i + 1) % points.size();
        const double chord = distance(points[i], points[next]);
        const double step = spacing == "uniform"       ? 1.0
                            : spacing == "centripetal" ? std::sqrt(chord)
                                                       : chord;
        if (step == 0.0) {
            return error(fmt::format("points {} and {} are the same, which spacing = {} cannot "
                                     "have",
                                     i + 1, next + 1, spacing),
                         {}, "remove one of them, or use spacing = uniform");
        }
        places.push_back(places.back() + step);
    }
    const double whole = places.back();
    for (double& place : places) {
        place /= whole;
    }
    return places;
}

bool is_closed(const Arguments& a) { return a.choice("closed") == "yes"; }

StageResult make_polyline(const Arguments& a) {
    const PointList& points = a.points("points");
    const bool closed = is_closed(a);
    Result<std::vector<double>> places = places_of(points, a.choice("spacing"), closed);
    if (!places) {
        return std::move(places.diagnostics);
    }
    Pieces pieces{std::move(*places), 1, closed};
    for (std::size_t k = 0; k < points.coordinates; ++k) {
        const std::vector<double> values = coordinate(points, k);
        std::vector<double>& lines = pieces.coordinates.emplace_back();
        for (std::size_t i = 0; i + 1 < pieces.breaks.size(); ++i) {
            lines.insert(lines.end(), {values[i], values[(i + 1) % values.size()] - values[i]});
        }
    }
    return curve_of(pieces);
}

/// A tangent at an open end, in units of one segment.
std::optional<Diagnostic> fault_of_tangent(const Arguments& a, std::string_view name,
                                           std::size_t coordinates) {
    if (!a.has(name)) {
        return std::nullopt;
    }
    if (is_closed(a)) {
        return error(fmt::format("a closed curve has no ends, so it cannot have a {}", name), {},
                     "remove it or use closed = no");
    }
    if (coordinates == 2 && a.triple(name)[2].constant() != 0.0) {
        return error(fmt::format("{} is not in the plane of the points", name), {},
                     "set its third coordinate to 0, or give the points a third coordinate");
    }
    return std::nullopt;
}

template <Interpolation interpolation>
StageResult make_interpolating(const Arguments& a) {
    const PointList& points = a.points("points");
    const bool closed = is_closed(a);
    for (const std::string_view name : {"start_tangent", "end_tangent"}) {
        if (std::optional<Diagnostic> fault = fault_of_tangent(a, name, points.coordinates)) {
            return std::move(*fault);
        }
    }
    Result<std::vector<double>> places = places_of(points, a.choice("spacing"), closed);
    if (!places) {
        return std::move(places.diagnostics);
    }
    const InterpolatingSpline spline(interpolation, std::move(*places), closed);
    const std::vector<double>& breaks = spline.breaks();
    const auto slope = [&](std::string_view name, std::size_t k, double width) {
        return a.has(name) ? std::optional(*a.triple(name)[k].constant() / width) : std::nullopt;
    };
    Pieces pieces{breaks, spline.degree(), closed};
    for (std::size_t k = 0; k < points.coordinates; ++k) {
        const EndSlopes ends{slope("start_tangent", k, breaks[1]),
                             slope("end_tangent", k, 1.0 - breaks[breaks.size() - 2])};
        pieces.coordinates.push_back(spline.coefficients(coordinate(points, k), ends));
    }
    return curve_of(pieces);
}

StageResult make_hermite(const Arguments& a) {
    const PointList& points = a.points("points");
    const PointList& tangents = a.points("tangents");
    if (points.size() != tangents.size() || points.coordinates != tangents.coordinates) {
        return error(
            fmt::format("{} points of {} coordinates do not match {} tangents of {} coordinates",
                        points.size(), points.coordinates, tangents.size(), tangents.coordinates),
            {}, "give one tangent for each point, with the same number of coordinates");
    }
    const bool closed = is_closed(a);
    const std::size_t segments = closed ? points.size() : points.size() - 1;
    Pieces pieces{equal_breaks(segments), 3, closed};
    for (std::size_t k = 0; k < points.coordinates; ++k) {
        std::vector<double> slopes = coordinate(tangents, k);
        for (double& slope : slopes) {
            slope *= static_cast<double>(segments);
        }
        pieces.coordinates.push_back(
            hermite_coefficients(pieces.breaks, coordinate(points, k), slopes));
    }
    return curve_of(pieces);
}

// --------------------------------------------------------------------- approximating curves

StageResult make_bezier_curve(const Arguments& a) {
    const PointList& points = a.points("points");
    const bool closed = is_closed(a);
    const Result<SplinePointer> spline =
        bezier_spline(points.size(), optional_count(a, "degree"), closed);
    return spline ? curve_of(**spline, points) : StageResult(spline.diagnostics);
}

StageResult make_bspline_curve(const Arguments& a) {
    const PointList& points = a.points("points");
    const Result<SplinePointer> spline =
        make_bspline(points.size(), degree_for(points.size(), optional_count(a, "degree")),
                     ends_of(a.choice("ends")));
    return spline ? curve_of(**spline, points) : StageResult(spline.diagnostics);
}

StageResult make_nurbs_curve(const Arguments& a) {
    const Result<WeightedPoints> weighted = weighted_points(a, 4);
    if (!weighted) {
        return weighted.diagnostics;
    }
    const std::size_t count = weighted->weights.size();
    const Result<SplinePointer> spline =
        make_bspline(count, degree_for(count, optional_count(a, "degree")),
                     ends_of(a.choice("ends")), optional_numbers(a, "knots"));
    if (!spline) {
        return spline.diagnostics;
    }
    Pieces pieces{(*spline)->breaks(), (*spline)->degree(), (*spline)->closed()};
    for (const std::vector<double>& values : weighted->coordinates) {
        pieces.coordinates.push_back((*spline)->coefficients(values));
    }
    pieces.weight = (*spline)->coefficients(weighted->weights);
    return curve_of(pieces);
}

StageParameter spacing_parameter(std::vector<std::string_view> choices) {
    return choice_parameter(
        "spacing", std::move(choices),
        "the range of u between two points: the same for all "
        "(uniform), proportional to their distance (chordal) or its square root (centripetal)");
}

StageParameter tangent_parameter(std::string_view name, std::string_view meaning) {
    return {.name = name,
            .type = TripleParameter{.constant = true},
            .optional = true,
            .meaning = meaning};
}

std::vector<StageParameter> interpolating_parameters() {
    return {points_parameter({2, 3}, 2, "the points on the curve, in sequence"),
            spacing_parameter({"centripetal", "uniform", "chordal"}),
            closed_parameter("closed", "whether the curve returns to the first point"),
            tangent_parameter("start_tangent",
                              "the tangent at the first point; its length is that of the "
                              "first segment at this speed"),
            tangent_parameter("end_tangent",
                              "the tangent at the last point; its length is that of the last "
                              "segment at this speed")};
}

}  // namespace

std::vector<StageEntry> spline_curves() {
    return {
        {.name = "polyline",
         .meaning = "straight lines from point to point, for u from 0 to 1",
         .formula = R"(
p = Pᵢ + s (Pᵢ₊₁ − Pᵢ)      s = (u − uᵢ)/(uᵢ₊₁ − uᵢ) between uᵢ and uᵢ₊₁
uᵢ   grows from 0 to 1 in steps in proportion to |Pᵢ₊₁ − Pᵢ|^α:
     α = 0 for uniform, 1/2 for centripetal, 1 for chordal
)",
         .parameters = {points_parameter({2, 3}, 2, "the corners, in sequence"),
                        spacing_parameter({"chordal", "uniform", "centripetal"}),
                        closed_parameter("closed", "whether the curve returns to the first point")},
         .make = make_polyline,
         .dimension = 1,
         .example = R"(// A room whose plan is given corner by corner.
camera angular_room {
    map  u = 1 .. 0, v = -40deg .. 40deg
    eye  product(polyline([(2, 0), (0.6, 1.2), (-2, 1), (-1.2, -1), (1, -1.2)], closed = yes),
                 circle)
    look normal
})"},
        {.name = "catmull_rom",
         .meaning = "a smooth curve through points, with tangents from neighbouring points, for u "
                    "from 0 to 1",
         .formula = R"(
p = (1 + 2s) (1 − s)² Pᵢ + s² (3 − 2s) Pᵢ₊₁
    + hᵢ s (1 − s) ((1 − s) mᵢ − s mᵢ₊₁)
s = (u − uᵢ)/hᵢ between uᵢ and uᵢ₊₁,   hᵢ = uᵢ₊₁ − uᵢ,   dᵢ = (Pᵢ₊₁ − Pᵢ)/hᵢ
mᵢ = (hᵢ dᵢ₋₁ + hᵢ₋₁ dᵢ)/(hᵢ₋₁ + hᵢ),
     the slope at Pᵢ of the parabola through it and its neighbours
Ends of an open curve: m₀ = 2d₀ − m₁, so that the first piece is a parabola, or
start_tangent/h₀; the last one likewise. Two points alone give a straight line.
uᵢ   grows from 0 to 1 in steps in proportion to |Pᵢ₊₁ − Pᵢ|^α:
     α = 0 for uniform, 1/2 for centripetal, 1 for chordal
)",
         .parameters = interpolating_parameters(),
         .make = make_interpolating<Interpolation::catmull_rom>,
         .dimension = 1,
         .example = R"(// A vase from the points of its outline.
camera vase {
    aspect 1
    map  u = 180deg .. -180deg, v = 0 .. 1
    eye  product(circle, catmull_rom([(0.5, -1.2), (0.9, -0.5), (0.8, 0.2), (0.3, 0.8), (0.5, 1.2)]))
    look normal
})"},
        {.name = "natural_spline",
         .meaning = "the cubic spline through points, with continuous curvature, for u from 0 to 1",
         .formula = R"(
p = (1 + 2s) (1 − s)² Pᵢ + s² (3 − 2s) Pᵢ₊₁
    + hᵢ s (1 − s) ((1 − s) mᵢ − s mᵢ₊₁)
s = (u − uᵢ)/hᵢ between uᵢ and uᵢ₊₁,   hᵢ = uᵢ₊₁ − uᵢ,   dᵢ = (Pᵢ₊₁ − Pᵢ)/hᵢ
mᵢ   solve  mᵢ₋₁/hᵢ₋₁ + 2 (1/hᵢ₋₁ + 1/hᵢ) mᵢ + mᵢ₊₁/hᵢ = 3 (dᵢ₋₁/hᵢ₋₁ + dᵢ/hᵢ),
     which makes p″ continuous
Ends of an open curve: p″ = 0, which leaves out the terms of the missing
piece, or m₀ = start_tangent/h₀; the last one likewise.
uᵢ   grows from 0 to 1 in steps in proportion to |Pᵢ₊₁ − Pᵢ|^α:
     α = 0 for uniform, 1/2 for centripetal, 1 for chordal
)",
         .parameters = interpolating_parameters(),
         .make = make_interpolating<Interpolation::natural>,
         .dimension = 1,
         .example = R"(// A tower on a plan with rounded corners.
camera soft_tower {
    aspect 3
    map  u = 1 .. 0, v = -0.6 .. 0.6
    eye  product(natural_spline([(2, 0), (0.7, 0.7), (0, 2), (-1.5, 1.5), (-1, -1), (0.5, -1.5)],
                                closed = yes),
                 curve(v) = [1 + v^2/2, v])
    look normal
})"},
        {.name = "hermite",
         .meaning = "cubic segments between points with given tangents, for u from 0 to 1",
         .formula = R"(
p = (1 + 2s) (1 − s)² Pᵢ + s² (3 − 2s) Pᵢ₊₁
    + s (1 − s) ((1 − s) Tᵢ − s Tᵢ₊₁)
s = n u − i on segment i of n;   Tᵢ   the tangents
)",
         .parameters =
             {points_parameter({2, 3}, 2, "the points on the curve, in sequence"),
              {.name = "tangents",
               .type = PointsParameter{.coordinates = {2, 3}, .min_points = 2},
               .meaning =
                   "the tangent at each point; its length is that of a segment at this speed"},
              closed_parameter("closed", "whether the curve returns to the first point")},
         .make = make_hermite,
         .dimension = 1,
         .example = R"(// A wall that leaves the line of sight and returns to it.
camera swerving_wall {
    map  u = 1 .. 0, v = -40deg .. 40deg
    eye  product(hermite([(1, -2), (1.5, 0), (1, 2)], tangents = [(0, 2), (1, 1.5), (0, 2)]),
                 circle)
    look normal
})"},
        {.name = "bezier",
         .meaning = "a Bézier curve, which starts at its first point and ends at its last, for u "
                    "from 0 to 1",
         .formula = R"(
p = Σⱼ C(n, j) sʲ (1 − s)ⁿ⁻ʲ P_(kn + j)      j = 0 … n = degree
s = m u − k on piece k of m
)",
         .parameters =
             {points_parameter({2, 3}, 2, "the control points, at most 8 for each piece"),
              optional_degree_parameter("degree of each piece; by default there is one piece"),
              closed_parameter("closed", "whether the last piece ends with the first point")},
         .make = make_bezier_curve,
         .dimension = 1,
         .example = R"(// A fan vault: rays leave a quarter arch rotated around the z axis.
camera vault {
    map  u = 70deg .. -70deg, v = 0 .. 1
    eye  product(circle, bezier([(3, 0), (3, 1.6), (2, 2), (0.5, 2.2)]))
    look normal
})"},
        {.name = "bspline",
         .meaning = "a B-spline curve, which approximates its points, for u from 0 to 1",
         .formula = R"(
p = Σᵢ Nᵢ(t) Pᵢ      Nᵢ   the B-splines of degree n on the knots t₀ ≤ t₁ ≤ …
t grows from t_n to t_m with u, for m points
clamped   n + 1 equal knots at each end, and steps of 1 between
open      steps of 1
closed    steps of 1, points repeated periodically; the curve starts where
          the weight of P₀ is largest for odd n, (P_last + 4P₀ + P₁)/6 for
          n = 3, and where those of P₀ and P₁ are equal for even n,
          (P₀ + P₁)/2 for n = 2
)",
         .parameters =
             {points_parameter({2, 3}, 2, "the control points"),
              optional_degree_parameter(
                  "degree of its pieces; by default 3, or the number of points minus 1"),
              ends_parameter(
                  "ends",
                  "clamped starts and ends at the end points, open does not reach them, closed "
                  "is periodic")},
         .make = make_bspline_curve,
         .dimension = 1,
         .example = R"(// All round from a plan shaped like a cloverleaf.
camera clover {
    aspect 3
    map  u = 1 .. 0, v = -30deg .. 30deg
    eye  product(bspline([(2, 0), (2, 2), (0, 1.6), (-2, 2), (-2, 0), (-2, -2), (0, -1.6), (2, -2)],
                         ends = closed),
                 circle)
    look normal
})"},
        {.name = "nurbs",
         .meaning =
             "a rational B-spline curve, which can represent conics exactly, for u from 0 to 1",
         .formula = R"(
p = Σᵢ Nᵢ(t) wᵢ Pᵢ / Σᵢ Nᵢ(t) wᵢ      wᵢ   the weights
Nᵢ   the B-splines of degree n on the knots, as for bspline
t grows from t_n to t_m with u, for m points
)",
         .parameters =
             {points_parameter({2, 3, 4}, 2,
                               "the control points; a fourth coordinate is the weight"),
              weights_parameter(),
              optional_degree_parameter(
                  "degree of its pieces; by default 3, or the number of points minus 1"),
              ends_parameter(
                  "ends",
                  "clamped starts and ends at the end points, open does not reach them, closed "
                  "is periodic; given knots override this"),
              knots_parameter("knots")},
         .make = make_nurbs_curve,
         .dimension = 1,
         .example = R"(// An exact half circle, revolved to a globe.
camera globe {
    map  u = 180deg .. -180deg, v = 0 .. 1
    eye  product(circle,
                 nurbs([(0, -1), (1, -1), (1, 0), (1, 1), (0, 1)],
                       weights = [1, sqrt(1/2), 1, sqrt(1/2), 1],
                       degree = 2, knots = [0, 0, 0, 1, 1, 2, 2, 2]))
    look normal
})"},
    };
}

}  // namespace balcony::camera
