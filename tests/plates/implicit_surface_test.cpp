// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Meshes of bodies that are given by a function.

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "common/implicit_surface.hpp"

namespace balcony::plates::implicit_surface_test {
namespace {

using scene::V3d;

// Two balls that run into each other, off the planes of the lattice: where vertices coincide, flat
// triangles are left out.
double peanut(const V3d& p) {
    return smooth_min((p - V3d(0.413, 0.017, 0.029)).length() - 0.5,
                      (p + V3d(0.387, -0.011, 0.023)).length() - 0.6, 0.2);
}

scene::Mesh made(double cell) {
    return implicit_surface(peanut, {V3d(-1.2, -0.8, -0.8), V3d(1.2, 0.8, 0.8)}, cell);
}

TEST(ImplicitSurface, LiesWhereTheFieldIsZero) {
    const scene::Mesh mesh = made(0.05);
    ASSERT_GT(mesh.positions.size(), 1000U);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        // One step of Newton's method from within half a cell leaves its square, over the radius.
        EXPECT_LT(std::abs(peanut(V3d(mesh.positions[i]))), 0.05 * 0.05 / 0.5);
        EXPECT_NEAR(mesh.normals[i].length(), 1.0F, 1e-5F);
    }
}

// Every edge has a triangle on either side, which goes along it the other way.
TEST(ImplicitSurface, IsClosed) {
    const scene::Mesh mesh = made(0.04);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const auto& corners : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++sides[{corners[k], corners[(k + 1) % 3]}];
        }
    }
    ASSERT_FALSE(sides.empty());
    for (const auto& [edge, count] : sides) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(sides.count({edge.second, edge.first}), 1U);
    }
}

TEST(ImplicitSurface, IsWoundLikeItsNormals) {
    const scene::Mesh mesh = made(0.05);
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& p = mesh.positions;
        EXPECT_GT((p[b] - p[a]).cross(p[c] - p[a]).dot(mesh.normals[a]), 0.0F);
    }
}

}  // namespace
}  // namespace balcony::plates::implicit_surface_test
