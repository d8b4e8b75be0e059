// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/poses.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace balcony::app::poses_test {
namespace {

using Imath::V3d;

V3d rotated(const camera::Pose& pose, const V3d& v) {
    V3d made;
    for (int row = 0; row < 3; ++row) {
        const auto& [x, y, z] = pose.rotation[static_cast<std::size_t>(row)];
        made[row] = x * v.x + y * v.y + z * v.z;
    }
    return made;
}

// To the right, down and ahead are (0, 1, 0), (0, 0, -1) and (-1, 0, 0): it looks back along x.
constexpr PoseMatrix opencv{{{0, 0, -1, 5}, {1, 0, 0, 6}, {0, -1, 0, 7}}};
// The same camera: up is the other way, and so is back.
constexpr PoseMatrix opengl{{{0, 0, 1, 5}, {1, 0, 0, 6}, {0, 1, 0, 7}}};
constexpr PoseMatrix balcony{{{-1, 0, 0, 5}, {0, -1, 0, 6}, {0, 0, 1, 7}}};

TEST(Poses, AreTheSameInAllAxes) {
    ASSERT_EQ(camera_axes().size(), 3U);
    for (const auto& [name, matrix] :
         {std::pair("opencv", opencv), {"opengl", opengl}, {"balcony", balcony}}) {
        const auto made = pose_of(matrix, name, Axes::z_up);
        ASSERT_TRUE(made) << name;
        EXPECT_EQ(made->position, (std::array{5.0, 6.0, 7.0})) << name;
        EXPECT_EQ(rotated(*made, {1, 0, 0}), V3d(-1, 0, 0)) << name;
        EXPECT_EQ(rotated(*made, {0, 1, 0}), V3d(0, -1, 0)) << name;
        EXPECT_EQ(rotated(*made, {0, 0, 1}), V3d(0, 0, 1)) << name;
    }
}

// In a world with y up, it looks along -z, with x to the right.
TEST(Poses, MayBeInAWorldWithYUp) {
    const auto made =
        pose_of({{{1, 0, 0, 5}, {0, -1, 0, 7}, {0, 0, -1, -6}}}, "opencv", Axes::y_up);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->position, (std::array{5.0, 6.0, 7.0}));
    EXPECT_EQ(rotated(*made, {1, 0, 0}), V3d(0, 1, 0));
    EXPECT_EQ(rotated(*made, {0, 1, 0}), V3d(-1, 0, 0));
    EXPECT_EQ(rotated(*made, {0, 0, 1}), V3d(0, 0, 1));
}

TEST(Poses, OfRoundedMatricesAreExactRotations) {
    PoseMatrix matrix = balcony;
    matrix[0][0] = -0.99998;
    matrix[1][0] = 0.00004;
    const auto made = pose_of(matrix, "balcony", Axes::z_up);
    ASSERT_TRUE(made);
    const V3d x = rotated(*made, {1, 0, 0});
    const V3d y = rotated(*made, {0, 1, 0});
    EXPECT_NEAR(x.length(), 1.0, 1e-15);
    EXPECT_NEAR(x.dot(y), 0.0, 1e-15);
    EXPECT_NEAR((x.cross(y) - rotated(*made, {0, 0, 1})).length(), 0.0, 1e-15);
}

TEST(Poses, HaveTheMatricesThatTheyWereMadeOf) {
    for (const Axes world : {Axes::z_up, Axes::y_up}) {
        for (const auto& [name, matrix] :
             {std::pair("opencv", opencv), {"opengl", opengl}, {"balcony", balcony}}) {
            const auto made = matrix_of(*pose_of(matrix, name, world), name, world);
            ASSERT_TRUE(made) << name;
            EXPECT_EQ(*made, matrix) << name;
        }
    }
    EXPECT_FALSE(matrix_of({}, "opencb", Axes::z_up));
}

TEST(Poses, CombineAsTheirPointsDo) {
    const camera::Pose outer = *pose_of(opencv, "balcony", Axes::z_up);
    const camera::Pose inner = *pose_of(opengl, "balcony", Axes::z_up);
    const camera::Pose both = combined(outer, inner);
    const auto placed = [](const camera::Pose& pose, const V3d& point) {
        return rotated(pose, point) + V3d(pose.position[0], pose.position[1], pose.position[2]);
    };
    const V3d point(1, 2, 3);
    EXPECT_EQ(placed(both, point), placed(outer, placed(inner, point)));
}

TEST(Poses, RefuseOtherMatrices) {
    PoseMatrix scaled = balcony;
    scaled[0][0] = -2.0;
    PoseMatrix mirrored = balcony;
    mirrored[2][2] = -1.0;
    PoseMatrix far = balcony;
    far[1][3] = std::numeric_limits<double>::infinity();
    PoseMatrix unknown = balcony;
    unknown[1][1] = std::numeric_limits<double>::quiet_NaN();
    for (const PoseMatrix& wrong : {scaled, mirrored, far, unknown}) {
        EXPECT_FALSE(pose_of(wrong, "balcony", Axes::z_up));
    }
    const auto misspelt = pose_of(balcony, "opencb", Axes::z_up);
    ASSERT_FALSE(misspelt);
    EXPECT_EQ(misspelt.diagnostics.front().remedy, "did you mean 'opencv'?");
}

}  // namespace
}  // namespace balcony::app::poses_test
