// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS: calibrated cameras whose lens is corrected by splines, so that no
// formula of a lens has to fit. A ray is the inverse of the published formula.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "camera/calibrated/distortion.hpp"
#include "camera/calibrated/image_model.hpp"
#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/transforms/control_lattice.hpp"

namespace balcony::camera {

namespace {

using expr::Table;

/// A coordinate of the correction over the stereographic plane, with its slopes.
class Correction {
public:
    Correction(std::span<const LatticeAxis> axes, std::vector<double> values, LatticeBasis basis) {
        const Table table = lattice_table(axes, std::move(values), basis);
        by_a_ = std::make_shared<const Table>(table.derivative(1));
        by_b_ = std::make_shared<const Table>(table.derivative(0));
        table_ = std::make_shared<const Table>(table);
    }

    template <class Number>
    [[nodiscard]] Dual<Number> operator()(const PlanePoint<Number>& p) const {
        return {at(table_, p), at(by_a_, p), at(by_b_, p)};
    }

private:
    using TablePointer = std::shared_ptr<const Table>;
    static double at(const TablePointer& table, const PlanePoint<double>& p) {
        return (*table)(std::array{p.b, p.a});
    }
    static Expr at(const TablePointer& table, const PlanePoint<Expr>& p) {
        return p.a.graph().lookup(table, std::array{p.b, p.a});
    }

    TablePointer table_, by_a_, by_b_;
};

/// The plane of the splines: where they are defined, and where they lead to.
class SplinedPlane {
public:
    SplinedPlane(Correction along_a, Correction along_b, const PlanePoint<double>& reach)
        : along_a_(std::move(along_a)), along_b_(std::move(along_b)), reach_(reach) {}

    /// How many steps of Newton's method from a point of the image's plane find the point that
    /// leads there; nothing if there is none.
    [[nodiscard]] std::optional<std::size_t> steps_to(const PlanePoint<double>& p) const;
    /// Requires that there is such a point.
    [[nodiscard]] PlanePoint<Expr> emit(const PlanePoint<Expr>& p, std::size_t steps,
                                        Emitter& emit) const;

private:
    static constexpr std::size_t max_steps = 16;

    /// What a point misses, and how that changes with it.
    template <class Number>
    struct Miss {
        Dual<Number> a, b;
        [[nodiscard]] Number determinant() const { return a.by_a * b.by_b - a.by_b * b.by_a; }
    };
    template <class Number>
    [[nodiscard]] Miss<Number> miss(const PlanePoint<Number>& found,
                                    const PlanePoint<Number>& p) const {
        const Dual<Number> a = along_a_(found);
        const Dual<Number> b = along_b_(found);
        return {{found.a + a.value - p.a, a.by_a + 1.0, a.by_b},
                {found.b + b.value - p.b, b.by_a, b.by_b + 1.0}};
    }
    template <class Number>
    [[nodiscard]] static PlanePoint<Number> moved(const PlanePoint<Number>& found,
                                                  const Miss<Number>& by) {
        const Number determinant = by.determinant();
        return {found.a - (by.b.by_b * by.a.value - by.a.by_b * by.b.value) / determinant,
                found.b - (by.a.by_a * by.b.value - by.b.by_a * by.a.value) / determinant};
    }
    [[nodiscard]] PlanePoint<double> within(const PlanePoint<double>& p) const {
        return {std::clamp(p.a, -reach_.a, reach_.a), std::clamp(p.b, -reach_.b, reach_.b)};
    }
    [[nodiscard]] PlanePoint<Expr> within(const PlanePoint<Expr>& p) const {
        Graph& graph = p.a.graph();
        return {max(min(p.a, graph.constant(reach_.a)), graph.constant(-reach_.a)),
                max(min(p.b, graph.constant(reach_.b)), graph.constant(-reach_.b))};
    }

    Correction along_a_, along_b_;
    PlanePoint<double> reach_;
};

std::optional<std::size_t> SplinedPlane::steps_to(const PlanePoint<double>& p) const {
    PlanePoint<double> found = within(p);
    for (std::size_t step = 0; step <= max_steps; ++step) {
        const Miss<double> left = miss(found, p);
        if (!(left.determinant() > 0.0)) {
            return std::nullopt;
        }
        if (std::hypot(left.a.value, left.b.value) <= inverse_accuracy) {
            return step;
        }
        found = within(moved(found, left));
    }
    return std::nullopt;
}

PlanePoint<Expr> SplinedPlane::emit(const PlanePoint<Expr>& p, std::size_t steps,
                                    Emitter& emit) const {
    PlanePoint<Expr> found = within(p);
    for (std::size_t step = 0; step < steps; ++step) {
        found = within(moved(found, miss(found, p)));
    }
    const Miss<Expr> left = miss(found, p);
    emit.require(left.a.value * left.a.value + left.b.value * left.b.value <=
                 emit(inverse_doubt * inverse_doubt));
    emit.require(0.0 < left.determinant());
    return found;
}

/// mrcal's splined stereographic model.
class SplinedModel final : public ImageModel {
public:
    SplinedModel(SplinedPlane plane, std::size_t steps) : plane_(std::move(plane)), steps_(steps) {}
    ObjectVector direction(Expr x, Expr y, Emitter& emit) const override {
        const auto [a, b] = plane_.emit({x, y}, steps_, emit);
        return {a, b, 1.0 - 0.25 * (a * a + b * b)};
    }

private:
    SplinedPlane plane_;
    std::size_t steps_;
};

/// Newton's steps for all of the image that the splines reach; nothing if that is nothing.
std::optional<std::size_t> steps_for(const ImageFrame& frame, const SplinedPlane& plane) {
    constexpr int places = 16;
    std::optional<std::size_t> most;
    for (int j = 0; j <= places; ++j) {
        for (int i = 0; i <= places; ++i) {
            const auto [a, b] =
                frame.normalized(frame.width * i / places, frame.height * j / places);
            most = std::max(most, plane.steps_to({a, b}));
        }
    }
    return most;
}

constexpr std::size_t fewest = 4;  // Columns, and rows.

StageResult make_splined(const Arguments& a) {
    const PointList& points = a.points("points");
    const std::size_t columns = a.count("columns");
    const bool cubic = a.count("order") == 3;
    const std::size_t rows = points.size() / columns;
    if (points.size() % columns != 0 || rows < fewest) {
        return error(
            fmt::format("{} points in {} columns are no grid of splines", points.size(), columns),
            {}, fmt::format("give columns x rows points, at least {0} x {0}", fewest));
    }
    // The field of view is that of the splines along u, which need control points beyond.
    const double edge = 2.0 * std::tan(0.25 * a.constant("fov"));
    const std::size_t margin = cubic ? 2 : 1;
    const double step = 2.0 * edge / static_cast<double>(columns - 1 - margin);
    const auto half = [&](std::size_t count) {
        return 0.5 * step * static_cast<double>(count - 1);
    };
    const std::array axes{LatticeAxis{-half(rows), half(rows), rows},
                          LatticeAxis{-half(columns), half(columns), columns}};
    const auto correction = [&](std::size_t coordinate) {
        std::vector<double> values;
        for (std::size_t i = 0; i < points.size(); ++i) {
            values.push_back(points[i][coordinate]);
        }
        return Correction(axes, std::move(values),
                          cubic ? LatticeBasis::b_spline : LatticeBasis::quadratic);
    };
    const double beyond = 0.5 * step * static_cast<double>(margin);
    const ImageFrame frame = frame_of(a);
    SplinedPlane plane(correction(0), correction(1), {half(columns) - beyond, half(rows) - beyond});
    const std::optional<std::size_t> steps = steps_for(frame, plane);
    Diagnostics warnings;
    if (!steps) {
        warnings.push_back(
            warning("these splines fold the image or end before it: there are no rays", {},
                    "check the order of the points, fov, and the focal length"));
    }
    // One more, as the steps were counted at some places only.
    return {calibrated_camera(
                a, frame, std::make_shared<SplinedModel>(std::move(plane), steps.value_or(0) + 1)),
            std::move(warnings)};
}

}  // namespace

std::vector<StageEntry> splined_cameras() {
    return {calibrated_row(
        {.name = "splined_stereographic",
         .meaning = "a calibrated camera by mrcal's richest model: a stereographic lens, corrected "
                    "by splines over its plane",
         .formula = R"(
the ray d of the pixel (u, v), whose forward formula is, with the unit vector d:
a = 2 d_x/(1 + d_z),   b = 2 d_y/(1 + d_z)
x = a + A(a, b),   y = b + B(a, b)      A, B   B-splines of the points
u = fx x + skew y + cx,   v = fy y + cy
no ray where the splines fold, or beyond their edges at a = ±2 tan(fov/4)
)",
         .parameters = {{.name = "points",
                         .type = PointsParameter{.coordinates = {2}, .min_points = fewest * fewest},
                         .meaning = "the control points (A, B), row by row from the top left one"},
                        {.name = "columns",
                         .type = CountParameter{.range = {.minimum = fewest, .maximum = 1000.0}},
                         .meaning = "number of points per row"},
                        {.name = "fov",
                         .type = NumberParameter{.unit = Unit::angle,
                                                 .range = {.minimum = 0.0,
                                                           .maximum = 6.2,
                                                           .excludes_minimum = true},
                                                 .constant = true},
                         .meaning = "the angle from the left edge of the splines to the right one"},
                        {.name = "order",
                         .type = CountParameter{.default_value = 3.0,
                                                .range = {.minimum = 2.0, .maximum = 3.0}},
                         .meaning = "3: cubic splines, or 2: quadratic ones"}},
         .make = make_splined,
         .example = R"(
// A lens whose corners are bent as no formula says.
camera odd_lens {
    eye splined_stereographic(width = 1200, height = 900, fx = 700, fov = 110deg, columns = 5, points = [
        (0.05, 0.03), (0, 0.02), (0, 0.01), (0, 0), (0.02, 0.01),
        (0.01, 0), (0, 0), (0, 0), (0, 0), (0, 0.03),
        (0, 0), (0, 0), (0, 0), (0, 0), (-0.04, 0),
        (-0.01, 0), (0, 0), (0, 0), (0, 0), (-0.02, -0.02),
        (-0.06, -0.08), (0, -0.03), (0, 0), (0.01, 0), (0, -0.05)])
}
)"})};
}

}  // namespace balcony::camera
