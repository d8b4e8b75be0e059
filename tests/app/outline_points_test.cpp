// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/solving/outline_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace balcony::app::outline_points_test {
namespace {

using scene::V3d;
using scene::V3f;

// A scene of two objects: a square, which is placed at a height of 3, and a far triangle.
scene::Scene squared() {
    scene::Scene made;
    scene::Mesh square;
    square.positions = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {9, 9, 9}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene::Mesh other;
    other.positions = {{50, 0, 0}, {51, 0, 0}, {50, 1, 0}};
    other.triangles = {{0, 1, 2}};
    made.meshes = {square, other};
    scene::M44d up;
    up.setTranslation(V3d(0, 0, 3));
    made.instances = {{scene::MeshIndex(0), up, 0}, {scene::MeshIndex(1), {}, 1}};
    made.objects = {{"square"}, {"other"}};
    return made;
}

}  // namespace

TEST(OutlinePoints, AreVerticesAndPointsOfLongEdges) {
    const std::vector<V3d> points = outline_points(squared(), {0});
    // The diagonal of 4 sqrt(2) has 16 parts, which are sqrt(2)/4 long, and a side has 12 of them.
    EXPECT_EQ(points.size(), 4U + 4U * 11U + 15U);
    for (const V3d& point : points) {
        EXPECT_EQ(point.z, 3.0);
        const bool on_side = point.x == 0.0 || point.x == 4.0 || point.y == 0.0 || point.y == 4.0;
        EXPECT_TRUE(on_side || std::abs(point.x - point.y) < 1e-12) << point.x << ' ' << point.y;
    }
    for (const V3d& corner : {V3d(0, 0, 3), V3d(4, 0, 3), V3d(4, 4, 3), V3d(0, 4, 3)}) {
        EXPECT_NE(std::find(points.begin(), points.end(), corner), points.end());
    }
}

TEST(OutlinePoints, OfVeryManyTheFarthestAreLeft) {
    scene::Scene round;
    scene::Mesh sphere;
    constexpr std::uint32_t columns = 300;
    constexpr std::uint32_t rows = 100;
    for (std::uint32_t i = 0; i < columns * rows; ++i) {
        const double u = 2.0 * std::numbers::pi * (i % columns) / columns;
        const double v = std::numbers::pi * (i / columns) / (rows - 1.0);
        // Layers of a sphere, one inside the other.
        const double radius = i % 2 == 0 ? 1.0 : 0.5;
        sphere.positions.emplace_back(V3d(radius * std::sin(v) * std::cos(u),
                                          radius * std::sin(v) * std::sin(u),
                                          radius * std::cos(v)));
        sphere.triangles.push_back({i, i, i});
    }
    round.meshes = {sphere};
    round.instances = {{scene::MeshIndex(0), {}, 0}};
    round.objects = {{"round"}};
    const std::vector<V3d> points = outline_points(round, {0});
    EXPECT_LE(points.size(), 2'000U);
    EXPECT_GT(points.size(), 1'000U);
    for (int i = 0; i < 200; ++i) {
        const V3d along = V3d(std::cos(i), std::sin(i), std::sin(0.7 * i)).normalized();
        double reach = 0.0;
        for (const V3d& point : points) {
            EXPECT_NEAR(point.length(), 1.0, 1e-6);
            reach = std::max(reach, point.dot(along));
        }
        // Vertices are 0.06 apart at most and directions less than 0.1, so that one is left that is
        // less than 0.1 from any direction.
        EXPECT_GT(reach, std::cos(0.1));
    }
}

}  // namespace balcony::app::outline_points_test
