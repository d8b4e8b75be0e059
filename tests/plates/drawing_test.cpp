// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "common/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "common/surfaces.hpp"

namespace balcony::plates::drawing_test {
namespace {

constexpr double length = 4.0;
constexpr double height = 2.0;
constexpr int pixels_round = 400;

const Color black(0.0);
const Color white(1.0);

// What is white, in units of area.
double white_area(const Drawing& drawing) {
    constexpr double step = length / pixels_round;
    double sum = 0.0;
    for (double y = step / 2.0; y < height; y += step) {
        for (double x = step / 2.0; x < length; x += step) {
            sum += drawing.at(V2d(x, y)).x;
        }
    }
    return sum * step * step;
}

Drawing filled(const Path& outline) {
    Drawing drawing(pixels_round, length, height, black);
    drawing.fill(outline, white);
    return drawing;
}

TEST(Drawing, FillsTheAreaOfAnOutline) {
    const Path disc = ellipse(V2d(2.0, 1.0), V2d(0.9, 0.5));
    // The polygon of an ellipse with n corners is smaller by (2 pi / n)^2 / 6: 0.07 % here.
    EXPECT_NEAR(white_area(filled(disc)), std::numbers::pi * 0.9 * 0.5, 0.002);
    // Coverage is exact along x, and steps by a quarter of a pixel along y: 1.4 * 0.0025 here.
    const Path box{V2d(0.303, 0.202), V2d(1.703, 0.202), V2d(1.703, 1.2), V2d(0.303, 1.2)};
    EXPECT_NEAR(white_area(filled(box)), 1.4 * 0.998, 0.004);
}

TEST(Drawing, GoesRound) {
    const V2d half(0.5, 0.4);
    const Drawing across = filled(ellipse(V2d(length, 1.0), half));
    const Drawing middle = filled(ellipse(V2d(length / 2.0, 1.0), half));
    for (double x = 0.005; x < length; x += 0.05) {
        const double moved = std::fmod(x + length / 2.0, length);
        EXPECT_NEAR(across.at(V2d(x, 1.1)).x, middle.at(V2d(moved, 1.1)).x, 1e-9) << x;
    }
}

TEST(Drawing, FillsWhereAnOutlineCrossesItself) {
    // Twice around: a rule of even and odd windings would leave a hole.
    const Path twice = arc(V2d(2.0, 1.0), 0.6, 0.0, 4.0 * std::numbers::pi);
    EXPECT_NEAR(white_area(filled(twice)), std::numbers::pi * 0.36, 0.003);
}

TEST(Drawing, AStrokeHasItsWidth) {
    const Path stroke = line({V2d(1.0, 1.0), V2d(3.0, 1.0)}, 0.2);
    // With half a disc at either end.
    EXPECT_NEAR(white_area(filled(stroke)), 2.0 * 0.2 + std::numbers::pi * 0.01, 0.002);
}

TEST(SmoothPath, PassesItsPoints) {
    const std::vector<V2d> points{V2d(0.0, 0.0), V2d(1.0, 2.0), V2d(3.0, 1.0), V2d(3.5, -1.0)};
    const Path path = smooth_path(points);
    for (const V2d& point : points) {
        const auto nearest =
            std::min_element(path.begin(), path.end(), [&](const V2d& a, const V2d& b) {
                return (a - point).length() < (b - point).length();
            });
        EXPECT_LT((*nearest - point).length(), 1e-12);
    }
}

TEST(SmoothSurface, NormalsAreThoseOfTheFormulaAndTrianglesAreWoundLikeThem) {
    const scene::Mesh mesh = smooth_surface(24, 12, [](double u, double v) {
        const double angle = 2.0 * std::numbers::pi * u;
        const double latitude = std::numbers::pi * (v - 0.5);
        return scene::V3d(std::cos(latitude) * std::cos(angle),
                          std::cos(latitude) * std::sin(angle), std::sin(latitude));
    });
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        EXPECT_GT(mesh.normals[i].dot(mesh.positions[i]), 0.999F);
    }
    for (const auto& [a, b, c] : mesh.triangles) {
        const scene::V3f cross =
            (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
        EXPECT_GT(cross.dot(mesh.positions[a] + mesh.positions[b] + mesh.positions[c]), -1e-6F);
    }
}

}  // namespace
}  // namespace balcony::plates::drawing_test
