// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/polygons/polygon.hpp"

#include <cmath>
#include <ctime>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace balcony::scene::testing::polygon_test {

namespace {

V3d area_of(const V3f& a, const V3f& b, const V3f& c) {
    return (V3d(b) - V3d(a)).cross(V3d(c) - V3d(a));
}

V3d area_of(const std::vector<V3f>& polygon) {
    V3d sum(0.0);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        sum += area_of(polygon[0], polygon[i], polygon[i + 1]);
    }
    return sum;
}

// The triangles of a simple polygon have its winding, and their areas add up to its own. Together
// this means that they cover it exactly once.
void expect_division(const std::vector<V3f>& polygon) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangulate(polygon, triangles);
    ASSERT_EQ(triangles.size(), polygon.size() - 2);
    const V3d whole = area_of(polygon);
    V3d sum(0.0);
    for (const auto& [a, b, c] : triangles) {
        const V3d area = area_of(polygon[a], polygon[b], polygon[c]);
        // Single rounding of the corners, relative to the whole.
        EXPECT_GE(area.dot(whole), -1e-6 * whole.length2());
        sum += area;
    }
    EXPECT_NEAR((sum - whole).length(), 0.0, 1e-6 * whole.length());
}

// A polygon around a point, with corners at random distances from it.
std::vector<V3f> star(std::size_t count, std::mt19937& random) {
    std::uniform_real_distribution<float> distance(0.2F, 1.0F);
    std::vector<V3f> corners;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
        const float r = distance(random);
        corners.emplace_back(r * static_cast<float>(std::cos(angle)),
                             r * static_cast<float>(std::sin(angle)), 0.0F);
    }
    return corners;
}

// A band along a spiral: every triangle is far from its corners' neighbours.
std::vector<V3f> spiral(std::size_t steps) {
    std::vector<V3f> corners;
    const auto at = [](std::size_t i, double shift) {
        const double angle = 0.1 * static_cast<double>(i);
        const double r = 1.0 + 0.05 * angle + shift;
        return V3f(static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle)),
                   0.0F);
    };
    for (std::size_t i = 0; i < steps; ++i) {
        corners.push_back(at(i, 0.0));
    }
    for (std::size_t i = steps; i > 0; --i) {
        corners.push_back(at(i - 1, 0.1));
    }
    return corners;
}

}  // namespace

TEST(Polygons, AreCoveredOnce) {
    std::mt19937 random(3);
    for (const std::size_t count : {3U, 4U, 5U, 8U, 30U, 300U}) {
        for (int i = 0; i < 20; ++i) {
            expect_division(star(count, random));
        }
    }
    expect_division(spiral(400));
}

// If all ears were tested against all corners, the tests would reach their limit, and the triangles
// overlap.
TEST(Polygons, OfThousandsOfCornersAreQuick) {
    const std::clock_t begin = std::clock();
    for (int i = 0; i < 2; ++i) {
        expect_division(spiral(max_polygon_corners / 2));
    }
    EXPECT_LT(std::clock() - begin, 3 * CLOCKS_PER_SEC / 2);
}

TEST(Polygons, MayLieInAnyPlaneAndWindEitherWay) {
    std::mt19937 random(4);
    Imath::M44f turned;
    turned.rotate(V3f(0.7F, 1.9F, -0.4F));
    for (int i = 0; i < 20; ++i) {
        std::vector<V3f> corners = star(12, random);
        for (V3f& corner : corners) {
            corner = corner * turned + V3f(5.0F, -3.0F, 100.0F);
        }
        expect_division(corners);
        std::reverse(corners.begin(), corners.end());
        expect_division(corners);
    }
}

TEST(Polygons, AConvexOneIsAFan) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangulate(std::vector<V3f>{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}}, triangles);
    EXPECT_EQ(triangles,
              (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

// Whatever the corners are, the triangles are two fewer.
TEST(Polygons, WithoutAShapeGiveTriangles) {
    std::mt19937 random(5);
    std::uniform_int_distribution<int> grid(0, 3);
    for (int i = 0; i < 200; ++i) {
        std::vector<V3f> corners(3 + random() % 20, V3f(0.0F));
        for (V3f& corner : corners) {
            corner = V3f(static_cast<float>(grid(random)), static_cast<float>(grid(random)), 1e12F);
        }
        std::vector<std::array<std::uint32_t, 3>> triangles;
        triangulate(corners, triangles);
        EXPECT_EQ(triangles.size(), corners.size() - 2);
    }
}

}  // namespace balcony::scene::testing::polygon_test
