// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Clip shapes: area, distance from the edge, symmetry, soft edges.

#include <cmath>
#include <numbers>

#include "support.hpp"

namespace balcony::camera::clip_shapes_test {

namespace {

constexpr double width = 300.0;
constexpr double height = 200.0;
using std::numbers::pi;

class ShapeProbe {
public:
    explicit ShapeProbe(const ClipShapePointer& shape, double softness = 0.0) {
        Emitter emit(graph_);
        const PicturePoint picture{{graph_.picture_x(), graph_.picture_y()},
                                   {emit(width), emit(height)}};
        roots_ = {shape->distance(picture, emit), shape->coverage(picture, emit(softness), emit)};
    }
    ShapeProbe(std::string_view name, const Given& given = {}, double softness = 0.0)
        : ShapeProbe(stage<ClipShape>(StageKind::clip_shape, name, given), softness) {}

    [[nodiscard]] double distance(double x, double y) const { return value(0, x, y); }
    [[nodiscard]] double coverage(double x, double y) const { return value(1, x, y); }

    /// Of what is covered, by the midpoint rule on squares of half a pixel.
    [[nodiscard]] double area() const {
        double sum = 0.0;
        for (double y = 0.25; y < height; y += 0.5) {
            for (double x = 0.25; x < width; x += 0.5) {
                sum += coverage(x, y) * 0.25;
            }
        }
        return sum;
    }

private:
    [[nodiscard]] double value(std::size_t root, double x, double y) const {
        return expr::evaluate(std::span(roots_).subspan(root, 1), {x, y, 0.0, {}}).front();
    }

    Graph graph_;
    std::vector<Expr> roots_;
};

Given list(std::vector<double> corners) { return {{"points", PointList{2, std::move(corners)}}}; }

/// build(graph, {x, y}) gives the value that is above 0 inside.
template <class Build>
ClipShapePointer formula_shape(const Build& build) {
    const auto* row = catalogue().find(StageKind::clip_shape, "formula");
    Arguments arguments;
    arguments.set_formula(formula(2, [&build](Graph& graph, const std::vector<Expr>& p) {
        return std::vector<Expr>{build(graph, p)};
    }));
    return std::dynamic_pointer_cast<const ClipShape>(*row->make(arguments));
}

ClipShapePointer disc_formula() {
    return formula_shape(
        [](Graph&, const std::vector<Expr>& p) { return 0.5 - p[0] * p[0] - p[1] * p[1]; });
}

struct Case {
    std::string name;
    ClipShapePointer shape;
    double area;  // By the textbook.
};

std::vector<Case> cases() {
    const auto shape = [](std::string_view name, const Given& given = {}) {
        return stage<ClipShape>(StageKind::clip_shape, name, given);
    };
    const double ellipse = pi * 0.25 * width * height;
    const double radius = 0.2 * height;
    return {
        {"rectangle", shape("rectangle"), width * height},
        {"ellipse", shape("ellipse"), ellipse},
        {"ring", shape("ring", {{"inner", numbers({0.6})}}), ellipse * (1.0 - 0.36)},
        {"rounded", shape("rounded", {{"radius", numbers({0.2})}}),
         width * height - (4.0 - pi) * radius * radius},
        {"polygon", shape("polygon", list({0.1, 0.1, 0.9, 0.1, 0.1, 0.9})),
         0.5 * 0.8 * 0.8 * width * height},
        // Sign-changing corners: a concave arrow.
        {"arrow", shape("polygon", list({0.5, 0.1, 0.9, 0.9, 0.5, 0.6, 0.1, 0.9})),
         (0.5 * 0.8 * 0.8 - 0.5 * 0.8 * 0.3) * width * height},
        // n triangles on either side of each tip: n r R sin(pi/n).
        {"star", shape("star", {{"points", numbers({5.0})}, {"inner", numbers({0.5})}}),
         5.0 * 0.5 * std::sin(pi / 5.0) * 0.25 * width * height},
        {"formula", disc_formula(), 0.5 * ellipse},
    };
}

}  // namespace

TEST(ClipShape, CoversTheAreaOfTheTextbook) {
    for (const Case& one : cases()) {
        // The midpoint rule errs by a fraction of the samples along the edge, which is less than
        // 3000 of them long.
        EXPECT_NEAR(ShapeProbe(one.shape).area(), one.area, 40.0) << one.name;
    }
}

// Along rays from the middle, or near it where that is outside, the edge is found by bisection;
// there the distance is 0 and its slope across the edge is 1.
TEST(ClipShape, DistanceHasSlopeOneAtTheEdge) {
    for (const Case& one : cases()) {
        const ShapeProbe probe(one.shape);
        for (int i = 0; i < 37; ++i) {
            // No multiple of this angle meets a corner.
            const double angle = 0.1 + 0.1697 * i;
            const auto on_ray = [&](double r) {
                return std::pair(0.5 * width + r * std::cos(angle),
                                 0.45 * height + r * std::sin(angle));
            };
            const auto [start_x, start_y] = on_ray(0.0);
            const bool starts_inside = probe.distance(start_x, start_y) <= 0.0;
            double near = 0.0;
            double far = 400.0;
            if (!starts_inside) {
                continue;
            }
            for (int step = 0; step < 60; ++step) {
                const double middle = 0.5 * (near + far);
                const auto [x, y] = on_ray(middle);
                (probe.distance(x, y) <= 0.0 ? near : far) = middle;
            }
            // A little outside of the edge, where the distance of a polygon has a derivative.
            const auto [x, y] = on_ray(near + 1e-3);
            constexpr double step = 1e-4;
            const double by_x =
                (probe.distance(x + step, y) - probe.distance(x - step, y)) / (2.0 * step);
            const double by_y =
                (probe.distance(x, y + step) - probe.distance(x, y - step)) / (2.0 * step);
            EXPECT_NEAR(std::hypot(by_x, by_y), 1.0, 2e-4) << one.name << " at " << x << ' ' << y;
        }
    }
}

TEST(ClipShape, SoftEdgesGoFromOneToZeroAcrossTheEdge) {
    const ShapeProbe ellipse("ellipse", {}, 20.0);
    const double middle = 0.5 * height;
    EXPECT_EQ(ellipse.coverage(150.0, middle), 1.0);
    EXPECT_EQ(ellipse.coverage(10.5, middle), 1.0);
    EXPECT_EQ(ellipse.coverage(-10.5, middle), 0.0);
    EXPECT_NEAR(ellipse.coverage(0.0, middle), 0.5, 1e-12);
    // What one side of the edge has lost the other one has.
    EXPECT_NEAR(ellipse.coverage(4.0, middle) + ellipse.coverage(-4.0, middle), 1.0, 0.02);
    EXPECT_EQ(ShapeProbe("ellipse").coverage(0.01, middle), 1.0);
    EXPECT_EQ(ShapeProbe("ellipse").coverage(-0.01, middle), 0.0);
}

TEST(ClipShape, AreSymmetricWhereTheyShould) {
    for (const char* name : {"rectangle", "ellipse", "ring", "rounded", "star"}) {
        const ShapeProbe probe(name);
        for (double y = 3.0; y < height; y += 17.0) {
            for (double x = 3.0; x < width; x += 17.0) {
                EXPECT_NEAR(probe.distance(x, y), probe.distance(width - x, y), 1e-9) << name;
                if (std::string_view(name) != "star") {
                    EXPECT_NEAR(probe.distance(x, y), probe.distance(x, height - y), 1e-9) << name;
                }
            }
        }
    }
    const ShapeProbe star("star");
    EXPECT_LT(star.distance(150.0, 10.0), 0.0) << "a tip at the top";
    EXPECT_GT(star.distance(150.0, 190.0), 0.0);
}

// Inside of the circles' middles the nearest side is as near as that of the rectangle.
TEST(RoundedRectangle, IsAsDeepAsTheRectangleAwayFromItsCorners) {
    const ShapeProbe rounded("rounded", {{"radius", numbers({0.1})}});
    const ShapeProbe rectangle("rectangle");
    for (const auto& [x, y] : {std::pair(150.0, 100.0), std::pair(150.0, 50.0),
                               std::pair(60.0, 90.0), std::pair(290.0, 100.0)}) {
        EXPECT_NEAR(rounded.distance(x, y), rectangle.distance(x, y), 1e-9);
    }
}

TEST(ClipFormula, RunsFromMinusOneToOneToTheRightAndUp) {
    const ShapeProbe upper(
        formula_shape([](Graph&, const std::vector<Expr>& p) { return p[1] - 0.5; }));
    EXPECT_NEAR(upper.distance(150.0, 20.0), -20.0, 1e-9) << "the picture's border is nearer";
    EXPECT_NEAR(upper.distance(150.0, 60.0), 10.0, 1e-9);
    const ShapeProbe right(
        formula_shape([](Graph&, const std::vector<Expr>& p) { return p[0] - 0.5; }));
    EXPECT_NEAR(right.distance(215.0, 100.0), 10.0, 1e-9);
    EXPECT_LT(right.distance(240.0, 100.0), 0.0);
}

TEST(ClipFormula, EndsAtThePicturesBorder) {
    const ShapeProbe whole(
        formula_shape([](Graph& graph, const std::vector<Expr>&) { return graph.constant(1.0); }));
    EXPECT_EQ(whole.coverage(150.0, 100.0), 1.0);
    EXPECT_NEAR(whole.distance(150.0, -10.0), 10.0, 1e-9);
    EXPECT_EQ(whole.coverage(310.0, 100.0), 0.0);
}

TEST(ClipFormula, IsOutsideWhereItHasNoValueAndHasAPlaceWhereItHasNoSlope) {
    const ShapeProbe half(
        formula_shape([](Graph&, const std::vector<Expr>& p) { return sqrt(p[0]); }));
    EXPECT_GT(half.distance(100.0, 100.0), 0.0);
    EXPECT_EQ(half.coverage(100.0, 100.0), 0.0);
    EXPECT_EQ(half.coverage(200.0, 100.0), 1.0);
    // At x = 0 the root's slope is not finite, and its sign says the side.
    const ShapeProbe cusp(
        formula_shape([](Graph&, const std::vector<Expr>& p) { return 0.5 - sqrt(abs(p[0])); }));
    EXPECT_LT(cusp.distance(150.0, 100.0), 0.0);
    const ShapeProbe none(
        formula_shape([](Graph&, const std::vector<Expr>& p) { return sqrt(abs(p[0])) - 0.5; }));
    EXPECT_GT(none.distance(150.0, 100.0), 0.0);
}

TEST(ImageMask, ShowsWhereTheImageIsWhite) {
    const auto image = std::make_shared<const GreyImage>(GreyImage{2, 1, {0.0F, 1.0F}});
    const ShapeProbe probe("image", {{"file", image}, {"invert", std::string("no")}});
    EXPECT_EQ(probe.coverage(10.0, 100.0), 0.0);
    EXPECT_EQ(probe.coverage(290.0, 100.0), 1.0);
    EXPECT_NEAR(probe.coverage(150.0, 30.0), 0.5, 1e-12);
    EXPECT_NEAR(probe.coverage(112.5, 30.0), 0.25, 1e-12);
    EXPECT_EQ(probe.coverage(310.0, 100.0), 0.0) << "outside of the picture";
    EXPECT_NEAR(probe.distance(140.0, 100.0), 10.0, 1e-9);
    const ShapeProbe inverse("image", {{"file", image}, {"invert", std::string("yes")}});
    for (double x = 1.0; x < width; x += 7.0) {
        EXPECT_NEAR(inverse.coverage(x, 50.0), 1.0 - probe.coverage(x, 50.0), 1e-12);
    }
}

TEST(ImageMask, HasItsRowsFromTheTop) {
    const auto image = std::make_shared<const GreyImage>(GreyImage{1, 3, {1.0F, 0.5F, 0.0F}});
    const ShapeProbe probe("image", {{"file", image}, {"invert", std::string("no")}});
    EXPECT_GT(probe.coverage(150.0, 20.0), 0.9);
    EXPECT_LT(probe.coverage(150.0, 180.0), 0.1);
}

TEST(Polygon, RefusesWhatHasNoSides) {
    EXPECT_FALSE(try_stage(StageKind::clip_shape, "polygon", list({0.1, 0.1, 0.1, 0.1, 0.5, 0.5})));
    // Also the last one and the first.
    EXPECT_FALSE(try_stage(StageKind::clip_shape, "polygon", list({0.1, 0.1, 0.5, 0.5, 0.1, 0.1})));
}

TEST(Polygon, HasAtMost256Corners) {
    const auto corners = [](std::size_t count) {
        std::vector<double> values;
        for (std::size_t i = 0; i < count; ++i) {
            const double angle = 2.0 * pi * static_cast<double>(i) / static_cast<double>(count);
            values.insert(values.end(), {0.5 + 0.5 * std::cos(angle), 0.5 + 0.5 * std::sin(angle)});
        }
        return list(std::move(values));
    };
    EXPECT_TRUE(try_stage(StageKind::clip_shape, "polygon", corners(256)));
    EXPECT_FALSE(try_stage(StageKind::clip_shape, "polygon", corners(257)));
}

}  // namespace balcony::camera::clip_shapes_test
