// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "balcony/clearance.hpp"
#include "support.hpp"

namespace balcony::dataset::poses_test {
namespace {

V3d place_of(const camera::Pose& pose) {
    return {pose.position[0], pose.position[1], pose.position[2]};
}
V3d ahead_of(const camera::Pose& pose) {
    return {pose.rotation[0][0], pose.rotation[1][0], pose.rotation[2][0]};
}

// The distance to the surfaces of the room, with z up: outside of the box, inside of the room.
double distance_in_room(const V3d& p) {
    const double walls = std::min({3.0 - std::abs(p.x), 2.0 - std::abs(p.y), p.z, 2.5 - p.z});
    const V3d beside(std::max(std::abs(p.x - 1.0) - 0.5, 0.0), std::max(std::abs(p.y) - 0.5, 0.0),
                     std::max(p.z - 2.0, 0.0));
    return std::min(walls, beside.length());
}

class Poses : public test::RoomTest {
protected:
    [[nodiscard]] std::vector<camera::Pose> poses(const std::string& group) const {
        const auto recipe = read(
            "seed = 3\nscenes = [\"room.obj\"]\ncameras = [\"pinhole\"]\n"
            "layers = [\"depth\"]\n[[poses]]\n" +
            group);
        EXPECT_TRUE(recipe) << to_text(recipe.diagnostics);
        const auto plan = recipe ? make_plan(*recipe) : Result<Plan>(recipe.diagnostics);
        EXPECT_TRUE(plan) << to_text(plan.diagnostics);
        std::vector<camera::Pose> made;
        if (!plan) {
            return made;
        }
        for (const PlannedPose& one : plan->scenes[0].poses) {
            made.push_back(one.pose);
        }
        return made;
    }
};

// A point of each kind: above a face, beside an edge, beyond a corner.
TEST_F(Poses, ClearanceIsTheDistanceToTheNearestTriangle) {
    const auto scene = scene::load((folder() / "room.obj").string());
    ASSERT_TRUE(scene);
    const std::vector<V3d> points{{-2, 0.5, 1}, {0.2, 0, 2.1},   {0.3, 0.7, 2.2},
                                  {1, 0, 2.3},  {-2.9, -1.8, 1}, {2.2, 0.1, 0.3}};
    const auto found = render::clearances(*scene, points, Axes::z_up);
    ASSERT_TRUE(found);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR((*found)[i], distance_in_room(points[i]), 1e-12) << i;
    }
}

// In the room, so outside of the box, which is closed: a place in it is not in sight.
TEST_F(Poses, AtRandomKeepClearAndStayInTheRoom) {
    constexpr double clearance = 0.4;
    const auto made = poses("random = 40\nclearance = 0.4\npitch = [-20, 10]\n");
    ASSERT_EQ(made.size(), 40U);
    for (const camera::Pose& pose : made) {
        EXPECT_GE(distance_in_room(place_of(pose)), clearance);
        const double pitch = std::asin(ahead_of(pose).z) * 180.0 / std::numbers::pi;
        EXPECT_GE(pitch, -20.0);
        EXPECT_LE(pitch, 10.0);
        EXPECT_NEAR(pose.rotation[2][1], 0.0, 1e-15);  // Level.
    }
}

// The box is wide enough for the clearance, but not in sight.
TEST_F(Poses, AreNotInClosedObjects) {
    const auto recipe = read(
        "scenes = [\"room.obj\"]\ncameras = [\"pinhole\"]\n[[poses]]\n"
        "random = 1\nclearance = 0.1\nbox = [[0.7, 0.5, -0.3], "
        "[1.3, 1.5, 0.3]]\n");
    ASSERT_TRUE(recipe) << to_text(recipe.diagnostics);
    const auto plan = make_plan(*recipe);
    ASSERT_FALSE(plan);
    const std::string said = to_text(plan.diagnostics);
    EXPECT_NE(said.find("recipe.toml:3:1"), std::string::npos) << said;
    EXPECT_NE(said.find("has room for 0 poses at random, not for 1"), std::string::npos) << said;
}

TEST_F(Poses, AreThoseOfTheSeed) {
    const auto same = [](const auto& a, const auto& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](auto& x, auto& y) {
            return x.position == y.position && x.rotation == y.rotation;
        });
    };
    const auto made = poses("random = 5\n");
    EXPECT_TRUE(same(made, poses("random = 5\n")));
    EXPECT_FALSE(same(made, poses("random = 5\n[[poses]]\nrandom = 5\n")));
    const auto two = poses("random = 5\n[[poses]]\nrandom = 5\n");
    EXPECT_TRUE(same(made, std::vector(two.begin(), two.begin() + 5)));
    EXPECT_FALSE(same(made, std::vector(two.begin() + 5, two.end())));
}

TEST_F(Poses, OnAPathMeetTheKeys) {
    const auto made = poses(R"(path = 5
keys = [
    {at = [-2, 1.5, 1], look_at = [0, 1.5, 1]},
    {at = [-1, 1.5, 1], look_at = [-1, 1.5, 0]},
    {at = [-1, 1.0, -1], direction = [-1, -1, 0]},
]
)");
    ASSERT_EQ(made.size(), 5U);
    // y up (x, y, z) is z up (x, -z, y).
    EXPECT_NEAR((place_of(made[0]) - V3d(-2, -1, 1.5)).length(), 0.0, 1e-12);
    EXPECT_NEAR((place_of(made[2]) - V3d(-1, -1, 1.5)).length(), 0.0, 1e-12);
    EXPECT_NEAR((place_of(made[4]) - V3d(-1, 1, 1)).length(), 0.0, 1e-12);
    EXPECT_NEAR((ahead_of(made[0]) - V3d(1, 0, 0)).length(), 0.0, 1e-12);
    EXPECT_NEAR((ahead_of(made[2]) - V3d(0, 1, 0)).length(), 0.0, 1e-12);
    EXPECT_NEAR((ahead_of(made[4]) - V3d(-1, 0, -1).normalized()).length(), 0.0, 1e-12);
}

// A closed path does not show its first place twice.
TEST_F(Poses, OnAClosedPathGoRound) {
    const std::string keys = R"(closed = true
ease = "linear"
keys = [
    {at = [-2, 1, 1], direction = [1, 0, 0]}, {at = [-1, 1, 1], direction = [1, 0, 0]},
    {at = [-1, 1, 0], direction = [1, 0, 0]}, {at = [-2, 1, 0], direction = [1, 0, 0]},
]
)";
    const auto made = poses("path = 8\n" + keys);
    ASSERT_EQ(made.size(), 8U);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_NEAR((place_of(made[i]) - place_of(made[(i + 1) % 8])).length(), 0.5, 1e-12) << i;
    }
}

}  // namespace
}  // namespace balcony::dataset::poses_test
