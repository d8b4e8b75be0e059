// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/curves/arc_length.hpp"

#include <numbers>

#include "support.hpp"

namespace balcony::camera::arc_length_test {

namespace {

constexpr double quarter = std::numbers::pi / 2.0;

// The length between two parameters by tanh-sinh quadrature, which does not mind that the speed is
// singular at an end.
double length_between(const GeneratorProbe& curve, double from, double to) {
    constexpr double step = 0.1;
    double sum = 0.0;
    for (int k = -32; k <= 32; ++k) {
        const double s = quarter * std::sinh(k * step);
        const double u = from + (to - from) * 0.5 * (1.0 + std::tanh(s));
        const double weight = quarter * std::cosh(k * step) / std::pow(std::cosh(s), 2);
        if (from < u && u < to) {
            sum += weight * length(curve(u).along_u);
        }
    }
    return sum * step * 0.5 * (to - from);
}

Given parts(double a, double b, double gamma, std::string_view by) {
    return {{"a", numbers({a})},
            {"b", numbers({b})},
            {"gamma", numbers({gamma})},
            {"by", std::string(by)}};
}

}  // namespace

// u is compared with the length that the curve by its angle has up to the same point, which the
// table under test has no part in. 1e-7 of the whole is what the class states; the worst measured
// is 2.2e-8, at gamma 0.05 and proportions of 10.
TEST(ArcLength, EqualStepsOfUAreEqualLengths) {
    for (const double gamma : {0.05, 0.1, 0.25, 0.7, 0.98, 1.0, 1.02, 1.3, 1.7, 1.99, 2.0}) {
        for (const auto& [a, b] :
             {std::pair(1.0, 1.0), std::pair(10.0, 1.0), std::pair(1.0, 10.0)}) {
            const GeneratorProbe by_length(
                object("superellipse", parts(a, b, gamma, "arc_length")));
            const GeneratorProbe by_angle(
                object("superellipse", parts(a, b, gamma, "angle_centre")));
            constexpr int steps = 97;
            // Closest at the ends of the quarter, where the curvature may be infinite.
            const auto fraction = [](int i) {
                return 0.5 - 0.5 * std::cos(2.0 * quarter * i / steps);
            };
            std::vector<double> lengths{0.0};
            double last = 0.0;
            for (int i = 1; i <= steps; ++i) {
                const Vector p = by_length(quarter * fraction(i)).point;
                const double angle = i < steps ? std::atan2(p[1] / b, p[0] / a) : quarter;
                lengths.push_back(lengths.back() + length_between(by_angle, last, angle));
                last = angle;
            }
            for (int i = 1; i <= steps; ++i) {
                // The fraction of a quarter; of the whole it is a fourth of that.
                EXPECT_NEAR(lengths[static_cast<std::size_t>(i)] / lengths.back() / 4.0,
                            fraction(i) / 4.0, 1e-7)
                    << "gamma " << gamma << ", half axes " << a << " and " << b;
            }
        }
    }
}

TEST(ArcLength, IsPeriodicAndSymmetric) {
    for (const double gamma : {0.25, 1.5}) {
        const GeneratorProbe curve(object("superellipse", parts(3.0, 2.0, gamma, "arc_length")));
        for (double u = 0.01; u < quarter; u += 0.1) {
            const Vector p = curve(u).point;
            // u in [0, 2 pi) is divided into quarters, which rounds.
            expect_near(curve(2.0 * quarter - u).point, {-p[0], p[1], 0.0}, 1e-13);
            expect_near(curve(2.0 * quarter + u).point, {-p[0], -p[1], 0.0}, 1e-13);
            expect_near(curve(-u).point, {p[0], -p[1], 0.0}, 1e-13);
            expect_near(curve(u + 8.0 * quarter).point, p, 1e-13);
        }
    }
}

TEST(ArcLength, TangentsAreThoseOfTheExactCurve) {
    const GeneratorProbe by_length(object("superellipse", parts(3.0, 2.0, 0.25, "arc_length")));
    const GeneratorProbe by_angle(object("superellipse", parts(3.0, 2.0, 0.25, "angle_centre")));
    for (double u = 0.05; u < 6.0; u += 0.1) {
        const Sample s = by_length(u);
        const Sample exact = by_angle(std::atan2(s.point[1] / 2.0, s.point[0] / 3.0));
        EXPECT_NEAR(
            length(cross(s.along_u, exact.along_u)) / (length(s.along_u) * length(exact.along_u)),
            0.0, 1e-13);
    }
}

TEST(ArcLength, NeedsConstantsAndAGammaItResolves) {
    const Formula time = formula(
        0, [](Graph& graph, const std::vector<Expr>&) { return std::vector{1.0 + graph.time()}; });
    Given moving = parts(1.0, 1.0, 1.0, "arc_length");
    moving["a"] = std::vector<Scalar>{Scalar(time)};
    EXPECT_FALSE(try_stage(StageKind::object_generator, "superellipse", moving));
    EXPECT_FALSE(
        try_stage(StageKind::object_generator, "superellipse", parts(1.0, 1.0, 2.1, "arc_length")));
}

TEST(EndGrading, MapsTheUnitRangeOntoItselfWithTheSlopeItStates) {
    for (const double crowding : {0.0, 0.5, 0.999, 1.0 - 2e-6}) {
        const EndGrading grading(crowding);
        EXPECT_NEAR(grading.fraction(0.0), 0.0, 1e-15);
        EXPECT_NEAR(grading.fraction(0.5), 0.5, 1e-15);
        EXPECT_NEAR(grading.fraction(1.0), 1.0, 1e-15);
        for (double position = 0.05; position < 1.0; position += 0.05) {
            constexpr double h = 1e-5;
            const double difference =
                (grading.fraction(position + h) - grading.fraction(position - h)) / (2.0 * h);
            // The third derivative is at most reach^3, about 400, which h^2 makes small.
            EXPECT_NEAR(grading.slope(position), difference, 1e-6);
        }
    }
}

}  // namespace balcony::camera::arc_length_test
