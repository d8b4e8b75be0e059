// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "common/mouldings.hpp"
#include "scenes/temple/dimensions.hpp"
#include "scenes/temple/measure_temple.hpp"
#include "scenes/temple/temple.hpp"

namespace balcony::plates::temple_builder_test {
namespace {

using scene::Mesh;
using scene::V3d;

V3d corner(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle, std::size_t k) {
    return V3d(mesh.positions[triangle[k]]);
}

// By the divergence theorem; positive if the triangles are counter-clockwise seen from outside.
double volume(const Mesh& mesh) {
    double sum = 0.0;
    for (const auto& triangle : mesh.triangles) {
        sum += corner(mesh, triangle, 0)
                   .dot(corner(mesh, triangle, 1).cross(corner(mesh, triangle, 2))) /
               6.0;
    }
    return sum;
}

double area(const Mesh& mesh) {
    double sum = 0.0;
    for (const auto& triangle : mesh.triangles) {
        const V3d first = corner(mesh, triangle, 0);
        sum +=
            (corner(mesh, triangle, 1) - first).cross(corner(mesh, triangle, 2) - first).length() /
            2.0;
    }
    return sum;
}

// A half circle makes a sphere. Its inscribed polyhedron lacks less than 1 - cos of half an angle
// of the profile in each of three directions, and 1 - sin(x)/x of an angle x about the axis.
TEST(Mouldings, AHalfCircleMakesASphere) {
    constexpr int pieces = 64;
    constexpr int segments = 128;
    Profile profile(V2d(0.0, -1.0));
    profile.arc({0.0, 1.0}, 0.5, pieces);
    const Mesh sphere = revolve(profile, segments);
    const double x = 2.0 * std::numbers::pi / segments;
    const double lacks =
        3.0 * (1.0 - std::cos(std::numbers::pi / pieces / 2.0)) + 1.0 - std::sin(x) / x;
    EXPECT_NEAR(volume(sphere) / (4.0 / 3.0 * std::numbers::pi), 1.0, lacks);
    for (std::size_t k = 0; k < sphere.positions.size(); ++k) {
        ASSERT_NEAR((sphere.positions[k] - sphere.normals[k]).length(), 0.0, 0.03F) << k;
    }
}

// What goes round a solid counter-clockwise encloses it; edges stay where the profile has them.
TEST(Mouldings, ARectangleMakesARing) {
    Profile profile(V2d(2.0, 0.0));
    profile.line({3.0, 0.0}).line({3.0, 1.0}).line({2.0, 1.0}).line({2.0, 0.0});
    const int segments = 400;
    const double turn = 2.0 * std::numbers::pi / segments;
    EXPECT_NEAR(volume(revolve(profile, segments)), segments / 2.0 * std::sin(turn) * (9.0 - 4.0),
                1e-4);
}

TEST(Mouldings, AFanFillsItsOutline) {
    const Mesh square = fan({V3d(0, 0, 2), V3d(3, 0, 2), V3d(3, 3, 2), V3d(0, 3, 2)});
    EXPECT_NEAR(area(square), 9.0, 1e-6);
    EXPECT_EQ(square.normals.front(), scene::V3f(0.0F, 0.0F, 1.0F));
}

const scene::Scene& small_temple() {
    static const Result<scene::Scene> made = make_temple({.texture_scale = 0.02});
    return *made;
}

TEST(Temple, ColumnsStandBetweenFloorAndArches) {
    const Extent ring = extent_of(small_temple(), "ring");
    for (int k = 1; k <= temple::column_count; ++k) {
        const Extent column = extent_of(small_temple(), fmt::format("column {}", k));
        EXPECT_NEAR(column.min_z, temple::floor_z, 0.06) << k;
        EXPECT_NEAR(column.max_z, temple::spring_z, 0.001) << k;
        const Extent arch = extent_of(small_temple(), fmt::format("arch {}", k));
        EXPECT_NEAR(arch.min_z, temple::spring_z, 0.02) << k;
        EXPECT_NEAR(arch.max_z, ring.min_z, 0.02) << k;
    }
}

TEST(Temple, TrianglesHaveAnAreaAndNormalsALength) {
    for (const Mesh& mesh : small_temple().meshes) {
        for (const auto& triangle : mesh.triangles) {
            const V3d first = corner(mesh, triangle, 0);
            const V3d cross =
                (corner(mesh, triangle, 1) - first).cross(corner(mesh, triangle, 2) - first);
            ASSERT_GT(cross.length(), 0.0) << mesh.name;
        }
        for (const scene::V3f& normal : mesh.normals) {
            ASSERT_NEAR(normal.length(), 1.0F, 1e-4F) << mesh.name;
        }
    }
}

}  // namespace
}  // namespace balcony::plates::temple_builder_test
