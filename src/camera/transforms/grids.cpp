// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Grid distortion: a lattice of control points over a box of parameter space (PCS → PCS) or of
// object space (OCS → OCS). The second is free-form deformation after T. W. Sederberg and
// S. R. Parry (SIGGRAPH 1986), with Bernstein polynomials as there or with B-splines.

#include <algorithm>

#include <fmt/format.h>

#include "camera/catalogue/families.hpp"
#include "camera/transforms/control_lattice.hpp"
#include "camera/transforms/offset_stages.hpp"

namespace balcony::camera {

namespace {

using expr::Table;
using TablePointer = std::shared_ptr<const Table>;

/// A table's coefficients take 8 bytes each.
constexpr std::size_t max_coefficients = std::size_t{1} << 20;

/// The offset of a point in the box of a lattice; one table per coordinate, whose axes are
/// in the order ..., v, u.
struct Offsets {
    std::vector<LatticeAxis> axes;
    std::vector<TablePointer> tables;

    /// The offset at the point of the box nearest to p.
    [[nodiscard]] std::vector<Expr> operator()(std::span<const Expr> point,
                                               const Emitter& emit) const {
        std::vector<Expr> p(point.rbegin(), point.rend());
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto [minimum, maximum] = std::minmax(axes[i].first, axes[i].last);
            p[i] = min(max(p[i], emit(minimum)), emit(maximum));
        }
        std::vector<Expr> offset;
        for (const TablePointer& table : tables) {
            offset.push_back(emit.graph().lookup(table, p));
        }
        return offset;
    }
};

LatticeBasis basis_of(const Arguments& a) {
    const std::string& word = a.choice("basis");
    return word == "b_spline"        ? LatticeBasis::b_spline
           : word == "interpolating" ? LatticeBasis::interpolating
                                     : LatticeBasis::bernstein;
}

/// The numbers of points along each axis: columns, rows, layers.
struct Counts {
    std::vector<std::size_t> along;
    std::vector<std::string_view> names;
};

Result<Counts> counts_of(const Arguments& a, std::vector<std::string_view> names) {
    const std::size_t total = a.points("points").size();
    Counts counts{{}, std::move(names)};
    std::size_t slab = 1;
    for (std::size_t i = 0; i + 1 < counts.names.size(); ++i) {
        counts.along.push_back(a.count(counts.names[i]));
        slab *= counts.along.back();
    }
    if (total % slab != 0) {
        return error(
            fmt::format("{} points do not fill {} of {} each", total, counts.names.back(), slab),
            {}, fmt::format("give a multiple of {} points", slab));
    }
    counts.along.push_back(total / slab);
    if (counts.along.back() < 2) {
        return error(fmt::format("the points form only one of the {}", counts.names.back()), {},
                     fmt::format("give at least {} points", 2 * slab));
    }
    return counts;
}

/// The error of points that cannot form a lattice of the basis.
Diagnostics unfit(const Counts& counts, std::span<const LatticeAxis> axes, LatticeBasis basis) {
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const std::string_view name = counts.names[axes.size() - 1 - i];
        if (axes[i].first == axes[i].last) {
            return {error(fmt::format("the box has no extent along its {}", name), {},
                          "make from and to differ in every coordinate")};
        }
        if (basis == LatticeBasis::bernstein && axes[i].points > max_bernstein_points) {
            return {error(
                fmt::format("a Bernstein lattice of {} {} has too high a degree", axes[i].points,
                            name),
                {}, fmt::format("give at most {}, or use basis = b_spline", max_bernstein_points))};
        }
    }
    if (coefficient_count(axes, basis) > max_coefficients) {
        return {error("the lattice has too many points", {},
                      fmt::format("a lattice has at most {} coefficients, but this one has {}",
                                  max_coefficients, coefficient_count(axes, basis)))};
    }
    return {};
}

/// One coordinate of the regular position of lattice point i.
double regular_place(const LatticeAxis& axis, std::size_t i) {
    const double part = static_cast<double>(i) / static_cast<double>(axis.points - 1);
    return axis.first + part * (axis.last - axis.first);
}

template <class Box>
Result<Offsets> offsets_of(const Arguments& a, const Box& from, const Box& to,
                           std::vector<std::string_view> names) {
    const Result<Counts> counts = counts_of(a, std::move(names));
    if (!counts) {
        return counts.diagnostics;
    }
    const std::size_t dimension = from.size();
    Offsets offsets;
    for (std::size_t axis = dimension; axis-- > 0;) {
        offsets.axes.push_back({from[axis].constant().value_or(0.0),
                                to[axis].constant().value_or(0.0), counts->along[axis]});
    }
    const LatticeBasis basis = basis_of(a);
    if (Diagnostics diagnostics = unfit(*counts, offsets.axes, basis); !diagnostics.empty()) {
        return diagnostics;
    }
    const PointList& points = a.points("points");
    const bool positions = a.choice("given") == "positions";
    std::size_t step = 1;
    for (std::size_t axis = 0; axis < dimension; ++axis) {
        const LatticeAxis& along = offsets.axes[dimension - 1 - axis];
        std::vector<double> values;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double place = regular_place(along, i / step % along.points);
            values.push_back(points[i][axis] - (positions ? place : 0.0));
        }
        offsets.tables.push_back(
            std::make_shared<const Table>(lattice_table(offsets.axes, std::move(values), basis)));
        step *= along.points;
    }
    return offsets;
}

StageParameter count_parameter(std::string_view name, std::string_view meaning) {
    return {.name = name,
            .type = CountParameter{.range = {.minimum = 2.0, .maximum = 1000.0}},
            .meaning = meaning};
}

/// The parameters after the points, their counts and their box.
void add_common_parameters(std::vector<StageParameter>& own) {
    own.push_back(choice_parameter("given", {"offsets", "positions"},
                                   "whether the points are offsets from the regular lattice or the "
                                   "new positions of its points"));
    own.push_back(
        choice_parameter("basis", {"b_spline", "interpolating", "bernstein"},
                         "approximates the points, interpolates them, or is one polynomial of "
                         "at most 8 points along an axis"));
    own.push_back(amount_parameter());
}

std::vector<StageParameter> parameter_grid_parameters() {
    const auto corner = [](std::string_view name, double at, std::string_view meaning) {
        return StageParameter{.name = name,
                              .type = PairParameter{.unit = Unit::either,
                                                    .default_value = std::array{at, at},
                                                    .constant = true},
                              .meaning = meaning};
    };
    std::vector<StageParameter> made{
        {.name = "points",
         .type = PointsParameter{.unit = Unit::either, .coordinates = {2}, .min_points = 4},
         .meaning = "(u, v), from the corner `from` along u, then row by row along v"},
        count_parameter("columns", "number of points per row"),
        corner("from", -1.0, "the corner (u, v) of the box at the first point"),
        corner("to", 1.0, "the corner at the last point")};
    add_common_parameters(made);
    return made;
}

std::vector<StageParameter> object_grid_parameters() {
    const auto corner = [](std::string_view name, double at, std::string_view meaning) {
        return StageParameter{
            .name = name,
            .type = TripleParameter{.default_value = std::array{at, at, at}, .constant = true},
            .meaning = meaning};
    };
    std::vector<StageParameter> made{
        {.name = "points",
         .type = PointsParameter{.coordinates = {3}, .min_points = 8},
         .meaning = "(x, y, z), from the corner `from` along x, then row by row along y, then "
                    "layer by layer along z"},
        count_parameter("columns", "number of points per row, along x"),
        count_parameter("rows", "number of rows per layer, along y"),
        corner("from", -1.0, "the corner (x, y, z) of the box at the first point"),
        corner("to", 1.0, "the corner at the last point")};
    add_common_parameters(made);
    return made;
}

}  // namespace

std::vector<StageEntry> grids() {
    return {
        {.kind = StageKind::parameter_transformer,
         .name = "grid",
         .meaning = "distorts parameter space by a lattice of control points; outside its box, the "
                    "offset of the nearest border point applies",
         .formula = R"(
(u′, v′) = (u, v) + amount Σᵢⱼ Bᵢ(s) Bⱼ(t) Δᵢⱼ      i = column, j = row
s = (columns − 1) (u − from₁)/(to₁ − from₁), t likewise from v and the rows
Δ   the points, as offsets from a regular lattice on the box from … to
B   b_spline: uniform cubic B-splines; the point beyond a border is
    Δ₋₁ = 2Δ₀ − Δ₁, so that border points are interpolated
    interpolating: natural cubic splines through the Δ, as products
    bernstein: Bernstein polynomials of the degree of the points − 1
Outside its box, a point takes the offset of the nearest point of the box.
)",
         .parameters = parameter_grid_parameters(),
         .make = [](const Arguments& a) -> StageResult {
             auto offsets = offsets_of(a, a.pair("from"), a.pair("to"), {"columns", "rows"});
             if (!offsets) {
                 return std::move(offsets.diagnostics);
             }
             return made<ParameterOffset<Offsets>>(std::move(*offsets), a.number("amount"));
         },
         .example = R"(camera grid {
    map    u = 1.2 .. -1.2, v = square
    warp   grid([(0, 0), (0, 0),      (0, 0),       (0, 0),
                 (0, 0), (0.4, 0.2),  (0.2, -0.4),  (0, 0),
                 (0, 0), (-0.2, 0.4), (-0.4, -0.2), (0, 0),
                 (0, 0), (0, 0),      (0, 0),       (0, 0)], columns = 4)
    eye    point
    toward plane((1, 0, 0))
})"},
        {.kind = StageKind::object_transformer,
         .name = "grid",
         .meaning =
             "free-form deformation: distorts object space by a lattice of control points; outside "
             "its box, the offset of the nearest border point applies",
         .formula = R"(
p′ = p + amount Σᵢⱼₖ Bᵢ(r) Bⱼ(s) Bₖ(t) Δᵢⱼₖ      i = column, j = row, k = layer
r = (columns − 1) (x − from₁)/(to₁ − from₁), s and t likewise from y and z
Δ   the points, as offsets from a regular lattice on the box from … to
B   b_spline: uniform cubic B-splines; the point beyond a border is
    Δ₋₁ = 2Δ₀ − Δ₁, so that border points are interpolated
    interpolating: natural cubic splines through the Δ, as products
    bernstein: Bernstein polynomials of the degree of the points − 1
Outside its box, a point takes the offset of the nearest point of the box.
)",
         .parameters = object_grid_parameters(),
         .make = [](const Arguments& a) -> StageResult {
             auto offsets =
                 offsets_of(a, a.triple("from"), a.triple("to"), {"columns", "rows", "layers"});
             if (!offsets) {
                 return std::move(offsets.diagnostics);
             }
             return made<ObjectOffset<Offsets>>(std::move(*offsets), a.number("amount"));
         },
         .example = R"(camera grid {
    map  u = 1.5 .. -1.5, v = square
    eye  plane
    move grid([(0, 0, 0), (0, 0, 0), (0.8, 0, 0), (0.8, 0, 0), (0, 0, 0), (0, 0, 0),
               (0, 0, 0), (0, 0, 0), (-0.8, 0, 0), (-0.8, 0, 0), (0, 0, 0), (0, 0, 0)],
              columns = 2, rows = 3)
})"},
    };
}

}  // namespace balcony::camera
