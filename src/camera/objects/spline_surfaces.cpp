// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS: free-form surfaces from a control net. The net is a list, row
// by row; u runs along the rows and v across them, both from 0 to 1. Outside an open side there
// is no point; a closed one is periodic.

#include <fmt/format.h>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/curves/spline_tables.hpp"

namespace balcony::camera {

namespace {

/// A piecewise polynomial of both parameters for each coordinate, divided by another one if there
/// are weights.
class SplineSurface final : public ObjectGenerator {
public:
    SplineSurface(CellPosition along_u, CellPosition along_v,
                  std::array<TablePointer, 3> coordinates, TablePointer weight)
        : along_u_(std::move(along_u)),
          along_v_(std::move(along_v)),
          coordinates_(std::move(coordinates)),
          weight_(std::move(weight)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const std::array at{along_u_(p.u, emit), along_v_(p.v, emit)};
        const auto value = [&](const TablePointer& table) {
            const Expr sum = emit.graph().lookup(table, at);
            return weight_ ? sum / emit.graph().lookup(weight_, at) : sum;
        };
        return {value(coordinates_[0]), value(coordinates_[1]), value(coordinates_[2])};
    }

private:
    CellPosition along_u_, along_v_;
    std::array<TablePointer, 3> coordinates_;
    TablePointer weight_;
};

struct NetSize {
    std::size_t columns, rows;
};

Result<NetSize> net_size(const Arguments& a) {
    const std::size_t points = a.points("points").size();
    const std::size_t columns = a.count("columns");
    if (points % columns != 0 || points < 2 * columns) {
        return error(fmt::format("{} points do not form rows of {} columns", points, columns), {},
                     "give at least two complete rows, row by row");
    }
    return NetSize{columns, points / columns};
}

/// The tensor product of two splines: first along each row of values, then, for each polynomial
/// coefficient of that, across the rows. The results are in the order of a table.
std::vector<double> tensor_coefficients(const Spline& along_u, const Spline& along_v,
                                        std::span<const double> values, std::size_t columns) {
    const std::size_t powers_u = along_u.degree() + 1;
    const std::size_t powers_v = along_v.degree() + 1;
    const std::size_t in_row = along_u.cells() * powers_u;
    std::vector<std::vector<double>> across(in_row);
    for (std::size_t begin = 0; begin < values.size(); begin += columns) {
        const std::vector<double> row = along_u.coefficients(values.subspan(begin, columns));
        for (std::size_t i = 0; i < in_row; ++i) {
            across[i].push_back(row[i]);
        }
    }
    std::vector<double> made(in_row * along_v.cells() * powers_v);
    for (std::size_t i = 0; i < in_row; ++i) {
        const std::vector<double> column = along_v.coefficients(across[i]);
        for (std::size_t k = 0; k < column.size(); ++k) {
            const std::size_t cell = i / powers_u * along_v.cells() + k / powers_v;
            made[(cell * powers_u + i % powers_u) * powers_v + k % powers_v] = column[k];
        }
    }
    return made;
}

/// Of one table: 32 MB. There are four at most, and their derivatives.
constexpr std::size_t max_coefficients = std::size_t{1} << 22U;

/// The surface over a net; `coordinates` hold the values of three coordinates, times the weights
/// if there are any.
StageResult surface_of(const Spline& along_u, const Spline& along_v, std::size_t columns,
                       std::span<const std::vector<double>> coordinates,
                       const std::vector<double>& weights = {}) {
    for (const Spline* along : {&along_u, &along_v}) {
        if (std::optional<Diagnostic> fault = fault_of_breaks(along->breaks())) {
            return std::move(*fault);
        }
    }
    const std::array axes{cells_axis(along_u.cells(), along_u.degree()),
                          cells_axis(along_v.cells(), along_v.degree())};
    const std::size_t in_cell = (along_u.degree() + 1) * (along_v.degree() + 1);
    if (along_u.cells() * along_v.cells() * in_cell > max_coefficients) {
        return error(fmt::format("a surface of {} x {} pieces with {} coefficients each is too "
                                 "large",
                                 along_u.cells(), along_v.cells(), in_cell),
                     {}, "give fewer points, or lower the degree");
    }
    const auto table = [&](std::span<const double> values) {
        return table_of(axes, tensor_coefficients(along_u, along_v, values, columns));
    };
    return made<SplineSurface>(
        CellPosition(along_u.breaks(), along_u.closed()),
        CellPosition(along_v.breaks(), along_v.closed()),
        std::array{table(coordinates[0]), table(coordinates[1]), table(coordinates[2])},
        weights.empty() ? nullptr : table(weights));
}

/// From the parameters points and columns, and what makes the spline along a side from the number
/// of its points and the side's letter.
template <class MakeSpline>
StageResult unweighted_surface(const Arguments& a, const MakeSpline& make_spline) {
    const Result<NetSize> size = net_size(a);
    if (!size) {
        return size.diagnostics;
    }
    const Result<SplinePointer> along_u = make_spline(size->columns, "u");
    const Result<SplinePointer> along_v = make_spline(size->rows, "v");
    if (!along_u || !along_v) {
        return along_u ? along_v.diagnostics : along_u.diagnostics;
    }
    const PointList& points = a.points("points");
    return surface_of(
        **along_u, **along_v, size->columns,
        std::array{coordinate(points, 0), coordinate(points, 1), coordinate(points, 2)});
}

/// The parameters that there are one of for each side.
struct Side {
    std::string_view degree, ends, knots, closed;
};
Side side(std::string_view letter) {
    return letter == "u" ? Side{"degree_u", "ends_u", "knots_u", "closed_u"}
                         : Side{"degree_v", "ends_v", "knots_v", "closed_v"};
}

StageResult make_bezier_patch(const Arguments& a) {
    return unweighted_surface(a, [&](std::size_t points, std::string_view letter) {
        return bezier_spline(points, optional_count(a, side(letter).degree),
                             a.choice(side(letter).closed) == "yes");
    });
}

StageResult make_bspline_patch(const Arguments& a) {
    return unweighted_surface(a, [&](std::size_t points, std::string_view letter) {
        return make_bspline(points, degree_for(points, optional_count(a, side(letter).degree)),
                            ends_of(a.choice(side(letter).ends)));
    });
}

StageResult make_interpolating_patch(const Arguments& a) {
    const Interpolation by =
        a.choice("by") == "natural" ? Interpolation::natural : Interpolation::catmull_rom;
    return unweighted_surface(
        a, [&](std::size_t points, std::string_view letter) -> Result<SplinePointer> {
            const bool closed = a.choice(side(letter).closed) == "yes";
            return SplinePointer(std::make_shared<const InterpolatingSpline>(
                by, equal_breaks(closed ? points : points - 1), closed));
        });
}

StageResult make_nurbs_patch(const Arguments& a) {
    const Result<NetSize> size = net_size(a);
    const Result<WeightedPoints> weighted = weighted_points(a, 4);
    if (!size || !weighted) {
        return size ? weighted.diagnostics : size.diagnostics;
    }
    const auto spline = [&](std::size_t points, const Side& along) {
        return make_bspline(points, degree_for(points, optional_count(a, along.degree)),
                            ends_of(a.choice(along.ends)), optional_numbers(a, along.knots));
    };
    const Result<SplinePointer> along_u = spline(size->columns, side("u"));
    const Result<SplinePointer> along_v = spline(size->rows, side("v"));
    if (!along_u || !along_v) {
        return along_u ? along_v.diagnostics : along_u.diagnostics;
    }
    return surface_of(**along_u, **along_v, size->columns, weighted->coordinates,
                      weighted->weights);
}

std::vector<StageParameter> net_parameters(std::vector<std::size_t> coordinates,
                                           std::string_view meaning) {
    return {points_parameter(std::move(coordinates), 4, meaning),
            {.name = "columns",
             .type = CountParameter{.range = {.minimum = 2.0, .maximum = 65536.0}},
             .meaning = "number of points per row, along u"}};
}

constexpr std::string_view bspline_degree =
    "degree of the pieces; by default 3, or the number of points minus 1";
constexpr std::string_view bspline_ends =
    "clamped interpolates the border curves of the net, open does not reach them, closed is "
    "periodic";

}  // namespace

std::vector<StageEntry> spline_surfaces() {
    return {
        {.name = "bezier_patch",
         .meaning =
             "a Bézier surface, which interpolates the corners of its net, for u and v from 0 to 1",
         .formula = R"(
p = Σᵢⱼ Bᵢ(u) Bⱼ(v) Pᵢⱼ      Pᵢⱼ   the point in column i of row j
B   the Bernstein polynomials of the piece, as for bezier
)",
         .parameters =
             net_parameters({3}, "the control points, row by row; at most 8 per side of a piece") +
             std::vector{
                 optional_degree_parameter(
                     "degree of each piece along u; by default there is one piece", "degree_u"),
                 optional_degree_parameter(
                     "degree of each piece along v; by default there is one piece", "degree_v"),
                 closed_parameter("closed_u", "whether rows end with their first point"),
                 closed_parameter("closed_v", "whether the last row is followed by the first")},
         .make = make_bezier_patch,
         .dimension = 2,
         .example = R"(// A sail in the wind: rays leave it along its normals.
camera sail {
    aspect 1
    map  u = 1 .. 0, v = 0 .. 1
    eye  bezier_patch([(0, -1, -1),  (2, -0.4, -1.2), (2, 0.6, -1.2), (0, 1.2, -1),
                       (0.5, -1, 0), (3, -0.3, 0),    (2.5, 0.5, 0),  (0.2, 1, 0),
                       (0, -0.6, 1), (1.5, -0.2, 1.4), (1, 0.2, 1.6), (0, 0.5, 2)], columns = 4)
    look normal
})"},
        {.name = "bspline_patch",
         .meaning = "a B-spline surface, which approximates its net, for u and v from 0 to 1",
         .formula = R"(
p = Σᵢⱼ Nᵢ(u) Nⱼ(v) Pᵢⱼ      Pᵢⱼ   the point in column i of row j
N   the B-splines of each side, as for bspline
)",
         .parameters = net_parameters({3}, "the control points, row by row") +
                       std::vector{optional_degree_parameter(bspline_degree, "degree_u"),
                                   optional_degree_parameter(bspline_degree, "degree_v"),
                                   ends_parameter("ends_u", bspline_ends),
                                   ends_parameter("ends_v", bspline_ends)},
         .make = make_bspline_patch,
         .dimension = 2,
         .example = R"(// A leaning tube of varying width, seen from its axis outwards.
camera leaning_tube {
    aspect 3
    map  u = 1 .. 0, v = 0 .. 1
    eye  bspline_patch([(2, 0, -1),    (0, 2, -1),    (-2, 0, -1),   (0, -2, -1),
                        (1.6, 0, 0),   (0.3, 1.4, 0), (-1, 0, 0),    (0.3, -1.4, 0),
                        (3, 0, 1),     (0.6, 2.4, 1), (-1.8, 0, 1),  (0.6, -2.4, 1),
                        (2, 0, 2),     (0.8, 1.2, 2), (-0.4, 0, 2),  (0.8, -1.2, 2)],
                       columns = 4, ends_u = closed)
    look normal
})"},
        {.name = "nurbs_patch",
         .meaning = "a rational B-spline surface, which can represent quadrics exactly, for u and "
                    "v from 0 to 1",
         .formula = R"(
p = Σᵢⱼ Nᵢ(u) Nⱼ(v) wᵢⱼ Pᵢⱼ / Σᵢⱼ Nᵢ(u) Nⱼ(v) wᵢⱼ
Pᵢⱼ, wᵢⱼ   the point in column i of row j and its weight
N   the B-splines of each side, as for nurbs
)",
         .parameters =
             net_parameters({3, 4},
                            "the control points, row by row; a fourth coordinate is the "
                            "weight") +
             std::vector{weights_parameter(), optional_degree_parameter(bspline_degree, "degree_u"),
                         optional_degree_parameter(bspline_degree, "degree_v"),
                         ends_parameter("ends_u", bspline_ends),
                         ends_parameter("ends_v", bspline_ends), knots_parameter("knots_u"),
                         knots_parameter("knots_v")},
         .make = make_nurbs_patch,
         .dimension = 2,
         .example = R"(// An exact quarter cylinder, bent back at its upper end.
camera apse {
    let w = sqrt(1/2)
    map  u = 1 .. 0, v = 0 .. 1
    eye  nurbs_patch([(2, -2, -1, 1),  (4, 0, -1, w),   (2, 2, -1, 1),
                      (2, -2, 0.4, 1), (4, 0, 0.4, w),  (2, 2, 0.4, 1),
                      (1, -1, 1.6, 1), (2, 0, 1.6, w),  (1, 1, 1.6, 1)],
                     columns = 3, degree_u = 2, degree_v = 2)
    look normal
})"},
        {.name = "interpolating_patch",
         .meaning = "a smooth surface through the points of a net, for u and v from 0 to 1",
         .formula = R"(
p = Σᵢⱼ Lᵢ(u) Lⱼ(v) Pᵢⱼ      Pᵢⱼ   the point in column i of row j
Lᵢ   the curve of `by`, catmull_rom or natural_spline, with spacing = uniform,
     through 1 at uᵢ and 0 at all other uₖ
uᵢ = i/(columns − 1), or i/columns if closed; vⱼ likewise
)",
         .parameters =
             net_parameters({3},
                            "the points on the surface, row by row, evenly spaced "
                            "in u and v") +
             std::vector{
                 choice_parameter("by", {"catmull_rom", "natural"},
                                  "tangents from the neighbours, which limits the influence "
                                  "of a point to its surroundings, or continuous curvature"),
                 closed_parameter("closed_u", "whether rows return to their first point"),
                 closed_parameter("closed_v", "whether the last row is followed by the first")},
         .make = make_interpolating_patch,
         .dimension = 2,
         .example =
             R"(// A wall with a bulge, from which rays spread: it shows a larger region at a smaller scale.
camera swelling_wall {
    map  u = 1 .. 0, v = 0 .. 1
    eye  interpolating_patch([(0, -2, -1), (0, -1, -1),  (0, 0, -1),  (0, 1, -1),  (0, 2, -1),
                              (0, -2, 0),  (0.5, -1, 0), (1, 0, 0),   (0.5, 1, 0), (0, 2, 0),
                              (0, -2, 1),  (0, -1, 1),   (0, 0, 1),   (0, 1, 1),   (0, 2, 1)],
                             columns = 5, by = natural)
    look normal
})"},
    };
}

}  // namespace balcony::camera
