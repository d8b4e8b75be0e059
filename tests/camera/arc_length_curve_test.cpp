// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Any curve by its length.

#include <numbers>

#include "support.hpp"

namespace balcony::camera::arc_length_curve_test {

namespace {

using std::numbers::pi;

Arguments::Value points(std::size_t coordinates, std::vector<double> values) {
    return PointList{coordinates, std::move(values)};
}

ObjectGeneratorPointer formula_curve(Formula made) {
    const StageEntry* row = catalogue().find(StageKind::object_generator, "curve");
    Arguments arguments;
    arguments.set_formula(std::move(made));
    return std::static_pointer_cast<const ObjectGenerator>(*row->make(arguments).value);
}

ObjectGeneratorPointer ellipse() {
    return formula_curve(formula(1, [](Graph& graph, const std::vector<Expr>& u) {
        return std::vector{5.0 * cos(u[0]), sin(u[0]), graph.constant(0.0)};
    }));
}

ObjectGeneratorPointer by_length(const ObjectGeneratorPointer& curve, double from, double to) {
    return object("arc_length",
                  {{"curve", curve}, {"from", numbers({from})}, {"to", numbers({to})}});
}

// The length of a curve of even pace is |dC/du| anywhere.
double worst_pace(const GeneratorProbe& curve) {
    double sum = 0.0;
    std::vector<double> speeds;
    for (double u = 0.00137; u < 1.0; u += 0.00281) {
        speeds.push_back(length(curve(u).along_u));
        sum += speeds.back();
    }
    const double mean = sum / static_cast<double>(speeds.size());
    double worst = 0.0;
    for (const double speed : speeds) {
        worst = std::max(worst, std::fabs(speed / mean - 1.0));
    }
    return worst;
}

}  // namespace

TEST(ArcLengthCurve, GoesAtAnEvenPace) {
    // The speed changes by 5 within a quarter of the ellipse; the pace is off by the derivative of
    // the error of a cubic, a third power of the cell.
    EXPECT_LT(worst_pace(GeneratorProbe(by_length(ellipse(), 0.0, 2.0 * pi))), 3e-5);
    const Arguments::Value space =
        points(3, {0, 0, 0, 1, 0.2, 1, 1.5, 1, 0, 3, 1.2, 2, 3.2, 2.5, 1});
    EXPECT_LT(worst_pace(GeneratorProbe(
                  by_length(object("natural_spline", {{"points", space}}), 0.0, 1.0))),
              1e-4);
    // The second derivative jumps at its points, which a cell has in its middle.
    EXPECT_LT(
        worst_pace(GeneratorProbe(by_length(object("catmull_rom", {{"points", space}}), 0.0, 1.0))),
        2e-2);
}

TEST(ArcLengthCurve, KeepsTheCurveAndItsEnds) {
    const GeneratorProbe curve(by_length(ellipse(), -0.5, 2.0));
    const GeneratorProbe backwards(by_length(ellipse(), 2.0, -0.5));
    for (double u = 0.0; u <= 1.0; u += 0.05) {
        const Vector p = curve(u).point;
        EXPECT_NEAR(p[0] * p[0] / 25.0 + p[1] * p[1], 1.0, 1e-14);
        // Each is off by 1e-6 of a length of ten at most.
        expect_near(backwards(1.0 - u).point, p, 2e-5);
    }
    expect_near(curve(0.0).point, {5.0 * std::cos(0.5), -std::sin(0.5), 0.0}, 1e-14);
    expect_near(curve(1.0).point, {5.0 * std::cos(2.0), std::sin(2.0), 0.0}, 1e-14);
    EXPECT_FALSE(curve(-0.01).valid);
    EXPECT_FALSE(curve(1.01).valid);
}

TEST(ArcLengthCurve, OfACircleIsItsAngle) {
    const GeneratorProbe curve(
        by_length(object("circle", {{"radius", numbers({2.0})}}), 0.0, 2.0 * pi));
    for (double u = -1.0; u < 2.0; u += 0.037) {
        const Sample s = curve(u);
        EXPECT_TRUE(s.valid) << "a curve that comes back goes round";
        expect_near(s.point, {2.0 * std::cos(2.0 * pi * u), 2.0 * std::sin(2.0 * pi * u), 0.0},
                    1e-12);
        EXPECT_NEAR(length(s.along_u), 4.0 * pi, 1e-10);
    }
}

TEST(ArcLengthCurve, BearsAPauseAndAnInfiniteSpeed) {
    const auto power = [](double exponent) {
        return formula_curve(formula(1, [=](Graph& graph, const std::vector<Expr>& u) {
            return std::vector{pow(u[0], exponent), graph.constant(0.0), graph.constant(0.0)};
        }));
    };
    // By its length each is the straight way from 0 to 1. Within the first cells a power is not
    // followed.
    for (const double exponent : {2.0, 3.0, 0.5}) {
        const GeneratorProbe curve(by_length(power(exponent), 0.0, 1.0));
        for (double u = 0.0; u <= 1.0; u += 0.01) {
            EXPECT_NEAR(curve(u).point[0], u, 2e-2) << exponent;
        }
    }
}

TEST(ArcLengthCurve, SaysWhatItCannotTabulate) {
    const auto said = [](const ObjectGeneratorPointer& curve, double from, double to) {
        const auto made =
            try_stage(StageKind::object_generator, "arc_length",
                      {{"curve", curve}, {"from", numbers({from})}, {"to", numbers({to})}});
        return made ? std::string() : to_text(made.diagnostics);
    };
    const ObjectGeneratorPointer moving =
        formula_curve(formula(1, [](Graph& graph, const std::vector<Expr>& u) {
            return std::vector{u[0] * graph.time(), u[0], graph.constant(0.0)};
        }));
    EXPECT_NE(said(moving, 0.0, 1.0).find("cannot change with time"), std::string::npos);
    for (const double at : {0.0, 1.0}) {
        EXPECT_NE(said(ellipse(), at, at).find("has no length"), std::string::npos);
    }
    const ObjectGeneratorPointer bezier =
        object("bezier", {{"points", points(2, {0, 0, 1, 1, 2, 0})}});
    EXPECT_NE(said(bezier, 0.0, 2.0).find("has no point at its parameter 1.000"),
              std::string::npos);
    // Just beyond the asymptote at 45deg.
    const ObjectGeneratorPointer hyperbola = object("hyperbola", {{"by", std::string("polar")}});
    EXPECT_NE(said(hyperbola, 0.0, 1.0).find("has no point at its parameter 0.785"),
              std::string::npos);
    EXPECT_EQ(said(bezier, 0.2, 0.9), "");
}

}  // namespace balcony::camera::arc_length_curve_test
