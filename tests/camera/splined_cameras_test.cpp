// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Cameras whose lenses are corrected by splines.

#include <random>

#include "support.hpp"

namespace balcony::camera::splined_cameras_test {

namespace {

/// A uniform B-spline of an order around 0, by the recursion of Cox and de Boor.
double b_spline(int order, double x) {
    const double half = 0.5 * (order + 1);
    if (order == 0) {
        return x >= -0.5 && x < 0.5 ? 1.0 : 0.0;
    }
    return ((x + half) * b_spline(order - 1, x + 0.5) + (half - x) * b_spline(order - 1, x - 0.5)) /
           order;
}

/// From the camera's axes to those of the formula.
Vector optical(const Vector& d) { return {-d[1], -d[2], d[0]}; }

}  // namespace

// mrcal's documentation of its splined stereographic model: the splines reach from edge to edge
// with one control point beyond each, or half of one.
TEST(SplinedStereographic, RaysPutIntoThePublishedFormulaGiveThePixel) {
    constexpr std::size_t columns = 9;
    constexpr std::size_t rows = 7;
    const double edge = 2.0 * std::tan(0.25 * 2.0);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> some(-0.02, 0.02);
    std::vector<double> points;
    for (std::size_t i = 0; i < 2 * columns * rows; ++i) {
        points.push_back(some(random));
    }
    for (const int order : {2, 3}) {
        const double step = 2.0 * edge / (static_cast<double>(columns) - order);
        const auto correction = [&](double a, double b, std::size_t coordinate) {
            double sum = 0.0;
            for (std::size_t i = 0; i < rows; ++i) {
                for (std::size_t j = 0; j < columns; ++j) {
                    const double along = a / step + 0.5 * (columns - 1.0) - static_cast<double>(j);
                    const double down = b / step + 0.5 * (rows - 1.0) - static_cast<double>(i);
                    sum += points[2 * (i * columns + j) + coordinate] * b_spline(order, along) *
                           b_spline(order, down);
                }
            }
            return sum;
        };
        const GeneratorProbe probe(object(
            "splined_stereographic", Given{{"radius", numbers({1.0})},
                                           {"width", numbers({1600.0})},
                                           {"height", numbers({1000.0})},
                                           {"fx", numbers({800.0})},
                                           {"fy", numbers({810.0})},
                                           {"columns", numbers({static_cast<double>(columns)})},
                                           {"fov", numbers({2.0})},
                                           {"order", numbers({static_cast<double>(order)})},
                                           {"points", PointList{2, points}}}));
        int valid = 0;
        for (double v = 5.0; v < 1000.0; v += 45.0) {
            for (double u = 5.0; u < 1600.0; u += 45.0) {
                const Sample s = probe(u, v);
                if (!s.valid) {
                    continue;
                }
                ++valid;
                const Vector d = optical(s.point);
                const double a = 2.0 * d[0] / (length(d) + d[2]);
                const double b = 2.0 * d[1] / (length(d) + d[2]);
                // The inverse is found to 1e-13 of a focal length.
                EXPECT_NEAR(800.0 * (a + correction(a, b, 0)) + 800.0, u, 1e-9) << order;
                EXPECT_NEAR(810.0 * (b + correction(a, b, 1)) + 500.0, v, 1e-9) << order;
            }
        }
        EXPECT_GT(valid, 700) << order;
    }
}

TEST(SplinedStereographic, EndsWhereTheSplinesDo) {
    const GeneratorProbe probe(
        object("splined_stereographic", Given{{"radius", numbers({1.0})},
                                              {"width", numbers({1000.0})},
                                              {"height", numbers({1000.0})},
                                              {"fx", numbers({400.0})},
                                              {"columns", numbers({4.0})},
                                              {"fov", numbers({2.0})},
                                              {"points", PointList{2, std::vector(32, 0.0)}}}));
    // Up to the 1e-5 of a focal length that an inverse may miss.
    constexpr double off = 0.005;
    const double edge = 800.0 * std::tan(0.5);
    EXPECT_TRUE(probe(500.0 + edge - off, 500.0).valid);
    EXPECT_FALSE(probe(500.0 + edge + off, 500.0).valid);
    EXPECT_FALSE(probe(500.0, 500.0 - edge - off).valid);
}

}  // namespace balcony::camera::splined_cameras_test
