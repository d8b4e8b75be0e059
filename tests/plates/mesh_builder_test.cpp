// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// By the divergence theorem, a closed mesh encloses the sum of the volumes of the tetrahedra
// between its triangles and the origin, if all triangles face outwards.

#include "common/mesh_builder.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace balcony::plates::mesh_builder_test {
namespace {

using std::numbers::pi;

double volume(const MeshBuilder& built) {
    const scene::Mesh mesh = built.mesh();
    double sum = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        sum += V3d(mesh.positions[a]).dot(V3d(mesh.positions[b]).cross(V3d(mesh.positions[c])));
    }
    return sum / 6.0;
}

// Normals are on the side of their triangles that the order of the corners says.
void expect_normals_outwards(const MeshBuilder& built) {
    const scene::Mesh mesh = built.mesh();
    for (const auto& [a, b, c] : mesh.triangles) {
        const V3d from(mesh.positions[a]);
        const V3d cross =
            (V3d(mesh.positions[b]) - from).cross(V3d(mesh.positions[c]) - from).normalized();
        for (const std::uint32_t corner : {a, b, c}) {
            EXPECT_NEAR(mesh.normals[corner].length(), 1.0F, 1e-6F);
            EXPECT_GT(cross.dot(V3d(mesh.normals[corner])), 0.0);
        }
    }
}

// Meshes store floats.
constexpr double rounding = 1e-5;

TEST(MeshBuilder, ABoxEnclosesItsVolume) {
    const MeshBuilder box = MeshBuilder().box(V3d(-1, 2, 3), V3d(1, 5, 4));
    EXPECT_NEAR(volume(box), 6.0, rounding);
    expect_normals_outwards(box);
}

// Twelve edges of the length 1 - 2c lose a prism of c²/2; of the cube c³ at each corner, 1/6 is
// left.
TEST(MeshBuilder, AChamferCutsEdgesAndCorners) {
    const double c = 0.1;
    const MeshBuilder box = MeshBuilder().box(V3d(0.0), V3d(1.0), c);
    const double cut = 12.0 * (1.0 - 2.0 * c) * c * c / 2.0 + 8.0 * 5.0 / 6.0 * c * c * c;
    EXPECT_NEAR(volume(box), 1.0 - cut, rounding);
    expect_normals_outwards(box);
}

TEST(MeshBuilder, RoundShapesFaceOutwards) {
    const V3d radii(1.0, 2.0, 0.5);
    const MeshBuilder ellipsoid = MeshBuilder().ellipsoid(V3d(3, 1, 2), radii, 96);
    // A polygon of these steps inscribed in a circle has an area smaller by 1/6 of a step squared.
    const double step = 2.0 * pi / 96.0;
    const double ellipsoid_volume = 4.0 / 3.0 * pi * radii.x * radii.y * radii.z;
    EXPECT_LT(volume(ellipsoid), ellipsoid_volume);
    EXPECT_NEAR(volume(ellipsoid), ellipsoid_volume, ellipsoid_volume * step * step);
    expect_normals_outwards(ellipsoid);

    const MeshBuilder cone =
        MeshBuilder().lathe(V3d(1, 0, 0), {{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {0.0, 2.0}}, 96);
    EXPECT_NEAR(volume(cone), pi * 2.0 / 3.0, pi * step * step);
    expect_normals_outwards(cone);

    const MeshBuilder tube =
        MeshBuilder().tube({{V3d(0, 0, 0), 0.5}, {V3d(0, 2, 0), 0.5}, {V3d(0, 4, 0), 0.5}}, 96);
    // Its ends are half spheres of four steps.
    EXPECT_NEAR(volume(tube), pi * 0.25 * 4.0 + 4.0 / 3.0 * pi * 0.125, 0.03);
    expect_normals_outwards(tube);
}

TEST(MeshBuilder, ABandEnclosesWhatIsBetweenItsLines) {
    const MeshBuilder band =
        MeshBuilder().band({{0, 0}, {1, 0}, {2, 0}}, {{0, 1}, {1, 3}, {2, 1}}, -1.0, 1.0);
    EXPECT_NEAR(volume(band), 8.0, rounding);
    expect_normals_outwards(band);
}

TEST(MeshBuilder, AMirroredPartStillFacesOutwards) {
    const MeshBuilder box = MeshBuilder().box(V3d(0.0), V3d(1, 2, 3));
    const MeshBuilder both = MeshBuilder().add(box).add(box, M44d().setScale(V3d(-1, 1, 1)));
    EXPECT_NEAR(volume(both), 12.0, rounding);
    expect_normals_outwards(both);
}

TEST(MeshBuilder, TextureCoordinatesAreSceneUnits) {
    const scene::Mesh wall =
        MeshBuilder().quad(V3d(1, 0, 0), V3d(4, 0, 0), V3d(4, 0, 2), V3d(1, 0, 2)).mesh();
    ASSERT_EQ(wall.texture_coordinates[0].size(), 4U);
    EXPECT_EQ(wall.texture_coordinates[0][1] - wall.texture_coordinates[0][0], scene::V2f(3, 0));
    EXPECT_EQ(wall.texture_coordinates[0][3] - wall.texture_coordinates[0][0], scene::V2f(0, -2));
}

}  // namespace
}  // namespace balcony::plates::mesh_builder_test
