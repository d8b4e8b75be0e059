// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "balcony/motion.hpp"
#include "scene_files.hpp"

namespace balcony::scene::testing::motion_test {

namespace {

using Motions = SceneFiles;

using std::numbers::pi;
// Times and values of files are floats, of the order of 1.
constexpr double float_rounding = 4e-7;

/// An animation of a node's property; the first animation if there is none.
void animate(Gltf& gltf, const Json& node, const std::string& path, const std::vector<float>& times,
             const std::vector<float>& values, std::size_t width,
             const std::string& interpolation = "LINEAR") {
    Json& animations = gltf.json["animations"];
    if (animations.is_null()) {
        animations = {
            {{"name", "moves"}, {"channels", Json::array()}, {"samplers", Json::array()}}};
    }
    Json& animation = animations.back();
    animation["samplers"].push_back({{"input", gltf.add_floats(times, 1)},
                                     {"output", gltf.add_floats(values, width)},
                                     {"interpolation", interpolation}});
    animation["channels"].push_back({{"sampler", animation["samplers"].size() - 1},
                                     {"target", {{"node", node}, {"path", path}}}});
}

V3d position_of(const Scene& scene, std::size_t instance = 0) {
    return scene.instances[instance].world_from_mesh.translation();
}

void expect_near(const V3d& actual, const V3d& expected, double tolerance = float_rounding) {
    EXPECT_LT((actual - expected).length(), tolerance)
        << actual.x << " " << actual.y << " " << actual.z;
}

/// The movement in an interval around the time of the scene.
Movement around(const Scene& scene, double duration) {
    return movement(scene, {scene.time - 0.5 * duration, scene.time + 0.5 * duration});
}

/// The keys of a quarter turn about z, as quaternions.
std::vector<float> quarter_turn() {
    const auto half = static_cast<float>(std::sqrt(0.5));
    return {0, 0, 0, 1, 0, 0, half, half};
}

}  // namespace

TEST_F(Motions, NodesMoveWithTheirParents) {
    Gltf gltf;
    const std::size_t mesh = gltf.add_triangle("mesh");
    gltf.add_node({{"name", "arm"}, {"children", {1}}, {"translation", {5, 0, 0}}});
    gltf.add_node({{"name", "hand"}, {"mesh", mesh}, {"translation", {1, 0, 0}}}, false);
    gltf.add_node({{"name", "still"}, {"mesh", mesh}});
    animate(gltf, 0, "rotation", {0, 2}, quarter_turn(), 4);
    animate(gltf, 1, "translation", {0, 1}, {1, 0, 0, 3, 0, 0}, 3);
    auto scene = load_glb(gltf);
    ASSERT_TRUE(scene && scene.diagnostics.empty()) << said(scene);
    ASSERT_TRUE(scene->motion);
    ASSERT_EQ(scene->motion->animations.size(), 1U);
    EXPECT_EQ(scene->motion->animations[0].name, "moves");
    EXPECT_EQ(scene->motion->animations[0].duration, 2.0);
    EXPECT_EQ(scene->motion->instances.size(), 1U) << "what stands still has no part in it";
    expect_near(position_of(*scene), V3d(6, 0, 0));
    for (const double time : {0.5, 1.0, 1.7, 2.0, 3.0}) {
        scene = moved_to(*scene, time);
        EXPECT_TRUE(scene.diagnostics.empty());
        EXPECT_EQ(scene->time, time);
        const double reach = 1.0 + 2.0 * std::min(time, 1.0);
        const double angle = pi / 4.0 * std::min(time, 2.0);
        expect_near(position_of(*scene),
                    V3d(5.0 + reach * std::cos(angle), reach * std::sin(angle), 0.0), 1e-6);
        EXPECT_EQ(position_of(*scene, 1), V3d(0.0));
    }
    scene = moved_to(*scene, 0.0);
    expect_near(position_of(*scene), V3d(6, 0, 0));
}

TEST_F(Motions, LightsAndCamerasMove) {
    Gltf gltf = one_triangle();
    gltf.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}}};
    gltf.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}}}}};
    const std::size_t node =
        gltf.add_node({{"name", "lamp"},
                       {"camera", 0},
                       {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    const auto half = static_cast<float>(std::sqrt(0.5));
    animate(gltf, node, "translation", {0, 1}, {0, 0, 0, 0, 8, 0}, 3);
    animate(gltf, node, "rotation", {0, 1}, {0, 0, 0, 1, 0, half, 0, half}, 4);
    auto scene = load_glb(gltf);
    ASSERT_TRUE(scene && scene.diagnostics.empty()) << said(scene);
    scene = moved_to(*scene, 1.0);
    expect_near(scene->lights[0].position, V3d(0, 8, 0));
    expect_near(scene->lights[0].direction, V3d(-1, 0, 0));
    expect_near(scene->cameras[0].position, V3d(0, 8, 0));
    expect_near(scene->cameras[0].forward, V3d(-1, 0, 0));
    const Movement moves = around(*scene, 0.5);
    ASSERT_EQ(moves.lights.size(), 1U);
    expect_near(moves.lights[0].positions.front(), V3d(0, 6, 0));
    expect_near(moves.lights[0].positions.back(), V3d(0, 8, 0));
    EXPECT_TRUE(moves.instances.empty());
}

TEST_F(Motions, StraightMovementHasTwoSteps) {
    Gltf gltf = one_triangle();
    animate(gltf, 0, "translation", {0, 4}, {0, 0, 0, 4, 8, 0}, 3);
    auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    scene = moved_to(*scene, 2.0);
    const Movement moves = around(*scene, 1.0);
    ASSERT_EQ(moves.instances.size(), 1U);
    const std::vector<M44d>& steps = moves.instances[0].world_from_mesh;
    ASSERT_EQ(steps.size(), 2U);
    expect_near(steps[0].translation(), V3d(1.5, 3, 0));
    expect_near(steps[1].translation(), V3d(2.5, 5, 0));
    scene = moved_to(*scene, 9.0);
    EXPECT_TRUE(around(*scene, 1.0).instances.empty()) << "the animation is over";
    EXPECT_TRUE(around(*scene, 0.0).instances.empty());
}

// Between the steps, a vertex stays within step_error of its true path.
TEST_F(Motions, StepsFollowRotations) {
    Gltf gltf = one_triangle();
    animate(gltf, 0, "rotation", {0, 2}, quarter_turn(), 4);
    auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    std::size_t before = 1;
    for (const double duration : {0.1, 0.5, 2.0}) {
        scene = moved_to(*scene, 1.0);
        const Movement moves = around(*scene, duration);
        ASSERT_EQ(moves.instances.size(), 1U);
        const std::vector<M44d>& steps = moves.instances[0].world_from_mesh;
        EXPECT_GE(steps.size(), before);
        before = steps.size();
        double largest = 0.0;
        for (int i = 0; i <= 1000; ++i) {
            const double place = 0.001 * i * static_cast<double>(steps.size() - 1);
            const std::size_t step = std::min(static_cast<std::size_t>(place), steps.size() - 2);
            const double part = place - static_cast<double>(step);
            const V3d corner = (1.0 - part) * (V3d(1, 0, 0) * steps[step]) +
                               part * (V3d(1, 0, 0) * steps[step + 1]);
            const double angle = pi / 4.0 * (1.0 + (0.001 * i - 0.5) * duration);
            const V3d truth(std::cos(angle), std::sin(angle), 0.0);
            largest = std::max(largest, (corner - truth).length());
        }
        // The diagonal of the triangle's bounds is sqrt(2), and a little more when it is turned.
        EXPECT_LT(largest, 2.0 * step_error) << duration;
    }
    EXPECT_GT(before, 4U);
    EXPECT_LT(before, 40U) << "no more steps than it takes";
}

// A movement to and fro that is back at the middle and at the ends of the interval.
TEST_F(Motions, StepsFollowManyKeys) {
    Gltf gltf = one_triangle();
    std::vector<float> times;
    std::vector<float> values;
    for (int key = 0; key <= 16; ++key) {
        times.push_back(static_cast<float>(key) / 16.0F);
        values.insert(values.end(), {key % 2 == 0 ? 0.0F : 1.0F, 0.0F, 0.0F});
    }
    animate(gltf, 0, "translation", times, values, 3);
    auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    scene = moved_to(*scene, 0.5);
    const Movement moves = around(*scene, 1.0);
    ASSERT_EQ(moves.instances.size(), 1U);
    EXPECT_EQ(moves.instances[0].world_from_mesh.size(), 17U);
}

TEST_F(Motions, NothingVanishesByScale) {
    Gltf gltf = one_triangle();
    animate(gltf, 0, "scale", {0, 1}, {0, 0, 0, 1, 1, 1}, 3, "STEP");
    auto scene = load_glb(gltf);
    ASSERT_TRUE(scene && scene.diagnostics.empty()) << said(scene);
    EXPECT_LT(scene->bounds().size().length(), 2e-6F);
    scene = moved_to(*scene, 1.0);
    EXPECT_TRUE(scene.diagnostics.empty());
    EXPECT_EQ(scene->bounds().max, V3f(1, 1, 0));
}

TEST_F(Motions, WhatCannotBePlacedStays) {
    Gltf gltf = one_triangle();
    animate(gltf, 0, "translation", {0, 1}, {3, 0, 0, 1e30F, 0, 0}, 3);
    auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    scene = moved_to(*scene, 1.0);
    const Diagnostics& found = scene.diagnostics;
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NE(to_text(found).find("object 'node' keeps its place at time 1: it reaches further"),
              std::string::npos)
        << to_text(found);
    expect_near(position_of(*scene), V3d(3, 0, 0));
    EXPECT_EQ(around(*scene, 1e-30).instances.size(), 0U);
}

TEST_F(Motions, BadChannelsAreNamed) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    struct Case {
        const char* said;
        void (*spoil)(Gltf&);
    };
    const std::vector<Case> cases{
        {"channel 0 (translation) is skipped: its times do not increase at key 1",
         [](Gltf& g) {
             animate(g, 0, "translation", {1, 1}, {0, 0, 0, 1, 1, 1}, 3);
         }},
        {"its times do not increase at key 0",
         [](Gltf& g) {
             animate(g, 0, "translation", {nan, 1}, {0, 0, 0, 1, 1, 1}, 3);
         }},
        {"its value 1 is not finite",
         [](Gltf& g) {
             animate(g, 0, "scale", {0, 1}, {0, 0, 0, 1, nan, 1}, 3);
         }},
        {"it has 2 keys and 3 values where 2 are required",
         [](Gltf& g) {
             animate(g, 0, "translation", {0, 1}, {0, 0, 0, 1, 1, 1, 2, 2, 2}, 3);
         }},
        {"it has 2 keys and 2 values where 6 are required",
         [](Gltf& g) {
             animate(g, 0, "translation", {0, 1}, {0, 0, 0, 1, 1, 1}, 3, "CUBICSPLINE");
         }},
        {"its interpolation 'BEZIER' is unknown",
         [](Gltf& g) {
             animate(g, 0, "translation", {0, 1}, {0, 0, 0, 1, 1, 1}, 3, "BEZIER");
         }},
        {"'colour' cannot be animated",
         [](Gltf& g) {
             animate(g, 0, "colour", {0, 1}, {0, 0, 0, 1, 1, 1}, 3);
         }},
        {"the file has no 'nodes' with index 7",
         [](Gltf& g) {
             animate(g, 7, "translation", {0, 1}, {0, 0, 0, 1, 1, 1}, 3);
         }},
        {"the file has no 'samplers' with index 4",
         [](Gltf& g) {
             animate(g, 0, "translation", {0, 1}, {0, 0, 0, 1, 1, 1}, 3);
             g.json["animations"][0]["channels"][0]["sampler"] = 4;
         }},
        {"it has no sampler",
         [](Gltf& g) {
             animate(g, 0, "translation", {0, 1}, {0, 0, 0, 1, 1, 1}, 3);
             g.json["animations"][0]["channels"][0].erase("sampler");
         }},
        {"an accessor has 3 components where 4 are required",
         [](Gltf& g) {
             animate(g, 0, "rotation", {0, 1}, {0, 0, 0, 1, 1, 1}, 3);
         }},
        {"animation 'moves' moves the node 'node' already",
         [](Gltf& g) {
             animate(g, 0, "translation", {0, 1}, {0, 0, 0, 1, 1, 1}, 3);
             animate(g, 0, "translation", {0, 1}, {0, 0, 0, 2, 2, 2}, 3);
         }},
        {"its node 'node' has a matrix, which cannot be animated",
         [](Gltf& g) {
             g.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
             animate(g, 0, "translation", {0, 1}, {0, 0, 0, 1, 1, 1}, 3);
         }},
    };
    for (const Case& spoiled : cases) {
        Gltf gltf = one_triangle();
        spoiled.spoil(gltf);
        const auto scene = load_glb(gltf);
        ASSERT_TRUE(scene) << said(scene);
        EXPECT_TRUE(says(scene, spoiled.said));
        EXPECT_TRUE(says(scene, "animation 'moves'"));
    }
}

TEST_F(Motions, StaticScenesHaveNone) {
    const auto scene = load_glb(one_triangle());
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_FALSE(scene->motion);
}

// Many channels that share one accessor would take far more memory than the file.
TEST_F(Motions, SharedKeysAreLimited) {
    Gltf gltf = one_triangle();
    const std::size_t keys = 100'000;
    std::vector<float> times(keys);
    for (std::size_t i = 0; i < keys; ++i) {
        times[i] = static_cast<float>(i);
    }
    const std::size_t input = gltf.add_floats(times, 1);
    const std::size_t output = gltf.add_floats(std::vector<float>(3 * keys, 0.0F), 3);
    Json channels = Json::array();
    Json samplers = Json::array();
    for (std::size_t i = 0; i < 200; ++i) {
        const std::size_t node = gltf.add_node({{"name", "n" + std::to_string(i)}});
        samplers.push_back({{"input", input}, {"output", output}});
        channels.push_back({{"sampler", i}, {"target", {{"node", node}, {"path", "translation"}}}});
    }
    gltf.json["animations"] = {{{"name", "bomb"}, {"channels", channels}, {"samplers", samplers}}};
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(says(scene, "more numbers than a file of its size may have"));
    EXPECT_LE(4 * keys * scene->motion->tracks.size(), 4 * gltf.glb().size() + (1U << 22U));
}

// ------------------------------------------------------------------------------ deformations

namespace {

/// A triangle whose second vertex a morph target lifts by 2, with the normals of the result.
Gltf lifted_triangle() {
    Gltf gltf = one_triangle();
    const std::size_t lift = gltf.add_floats({0, 0, 0, 0, 0, 2, 0, 0, 0}, 3);
    gltf.primitive(0)["targets"] = {{{"POSITION", lift}}};
    return gltf;
}

/// A triangle with two joints: the first vertex follows one, the second one the other, and the
/// third one both. The joint "arm" is at (1, 0, 0), to which the mesh is bound.
Gltf skinned_triangle() {
    Gltf gltf = one_triangle();
    const std::size_t joints = gltf.add_shorts({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, 4);
    const std::size_t weights = gltf.add_floats({1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0}, 4);
    gltf.primitive(0)["attributes"]["JOINTS_0"] = joints;
    gltf.primitive(0)["attributes"]["WEIGHTS_0"] = weights;
    const std::size_t matrices = gltf.add_floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,
                                                  1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1},
                                                 16);
    gltf.json["accessors"][matrices]["type"] = "MAT4";
    const std::size_t root = gltf.add_node({{"name", "root"}});
    const std::size_t arm = gltf.add_node({{"name", "arm"}, {"translation", {1, 0, 0}}}, false);
    gltf.json["nodes"][root]["children"] = {arm};
    gltf.json["skins"] = {{{"joints", {root, arm}}, {"inverseBindMatrices", matrices}}};
    gltf.json["nodes"][0]["skin"] = 0;
    gltf.json["nodes"][0]["translation"] = {0, 0, 100};  // Which a skin ignores.
    return gltf;
}

}  // namespace

TEST_F(Motions, MorphTargetsFollowTheirWeights) {
    Gltf gltf = lifted_triangle();
    animate(gltf, 0, "weights", {0, 1}, {0, 1}, 1);
    auto scene = load_glb(gltf);
    ASSERT_TRUE(scene && scene.diagnostics.empty()) << said(scene);
    EXPECT_EQ(scene->meshes[0]->positions[1], V3f(1, 0, 0));
    scene = moved_to(*scene, 0.25);
    EXPECT_EQ(scene->meshes[0]->positions[1], V3f(1, 0, 0.5F));
    EXPECT_EQ(scene->meshes[0]->positions[2], V3f(0, 1, 0));
    const Movement moves = around(*scene, 0.1);
    ASSERT_EQ(moves.meshes.size(), 1U);
    ASSERT_EQ(moves.meshes[0].shapes->size(), 2U) << "straight lines";
    EXPECT_NEAR(moves.meshes[0].shapes->back().positions[1].z, 0.6F, float_rounding);
}

TEST_F(Motions, MovedScenesShareWhatKeepsItsShape) {
    Gltf gltf = lifted_triangle();
    gltf.add_node({{"name", "still"}, {"mesh", gltf.add_triangle("mesh")}});
    animate(gltf, 0, "weights", {0, 1}, {0, 1}, 1);
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    const Result<Scene> moved = moved_to(*scene, 0.25);
    ASSERT_EQ(moved->meshes.size(), 2U);
    EXPECT_EQ(&*moved->meshes[1], &*scene->meshes[1]);
    EXPECT_NE(&*moved->meshes[0], &*scene->meshes[0]);
    EXPECT_EQ(scene->meshes[0]->positions[1], V3f(1, 0, 0));
    EXPECT_EQ(scene->time, 0.0);
}

TEST_F(Motions, WeightsWithoutAnimationAreApplied) {
    Gltf gltf = lifted_triangle();
    gltf.json["meshes"][0]["weights"] = {0.5};
    gltf.add_node({{"name", "own"}, {"mesh", 0}, {"weights", {2.0}}});
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene && scene.diagnostics.empty()) << said(scene);
    ASSERT_EQ(scene->meshes.size(), 2U);
    EXPECT_EQ(scene->meshes[0]->positions[1], V3f(1, 0, 1));
    EXPECT_EQ(scene->meshes[1]->positions[1], V3f(1, 0, 4))
        << "a node's weights replace the mesh's";
    EXPECT_FALSE(scene->motion);
}

TEST_F(Motions, FlatNormalsFollowTheShape) {
    Gltf gltf = lifted_triangle();
    gltf.primitive(0)["attributes"].erase("NORMAL");
    gltf.json["meshes"][0]["weights"] = {0.5};
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene && scene.diagnostics.empty()) << said(scene);
    const Mesh& mesh = scene->meshes[0];
    // The triangle (0,0,0) (1,0,1) (0,1,0).
    const V3f expected = V3f(-1, 0, 1).normalized();
    for (const V3f& normal : mesh.normals) {
        EXPECT_LT((normal - expected).length(), 1e-6F) << normal.x << ' ' << normal.z;
    }
}

TEST_F(Motions, VerticesFollowTheirJoints) {
    Gltf gltf = skinned_triangle();
    const std::size_t arm = gltf.json["nodes"].size() - 1;
    animate(gltf, arm, "rotation", {0, 1}, quarter_turn(), 4);
    auto scene = load_glb(gltf);
    ASSERT_TRUE(scene && scene.diagnostics.empty()) << said(scene);
    EXPECT_EQ(scene->instances[0].world_from_mesh, M44d()) << "joints place the mesh";
    expect_near(V3d(scene->meshes[0]->positions[2]), V3d(0, 1, 0));
    scene = moved_to(*scene, 1.0);
    const Mesh& mesh = scene->meshes[0];
    expect_near(V3d(mesh.positions[0]), V3d(0, 0, 0));
    expect_near(V3d(mesh.positions[1]), V3d(1, 0, 0));
    // Half way between where it was, and (0, 1) turned about (1, 0), which is (0, -1).
    expect_near(V3d(mesh.positions[2]), V3d(0, 0, 0));
    const Movement moves = around(*scene, 1.0);
    ASSERT_EQ(moves.meshes.size(), 1U);
    EXPECT_GT(moves.meshes[0].shapes->size(), 2U) << "an arc";
    EXPECT_TRUE(moves.instances.empty());
}

TEST_F(Motions, BadDeformationsAreNamed) {
    struct Case {
        const char* said;
        Gltf (*make)();
        void (*spoil)(Gltf&);
    };
    const std::vector<Case> cases{
        {"its 'weights' has 3 numbers where 1 are required", lifted_triangle,
         [](Gltf& g) {
             g.json["meshes"][0]["weights"] = {1, 2, 3};
         }},
        {"a displacement of its morph targets is not finite", lifted_triangle,
         [](Gltf& g) {
             constexpr float nan = std::numeric_limits<float>::quiet_NaN();
             g.primitive(0)["targets"][0]["POSITION"] =
                 g.add_floats({0, 0, 0, nan, 0, 2, 0, 0, 0}, 3);
         }},
        {"its POSITION are fewer than its positions", lifted_triangle,
         [](Gltf& g) {
             g.primitive(0)["targets"][0]["POSITION"] = g.add_floats({0, 0, 0}, 3);
         }},
        {"it has a skin, but no JOINTS_0 and WEIGHTS_0", skinned_triangle,
         [](Gltf& g) { g.primitive(0)["attributes"].erase("WEIGHTS_0"); }},
        {"a vertex follows joint 1 of 1", skinned_triangle,
         [](Gltf& g) { g.json["skins"][0]["joints"].erase(1); }},
        {"its joint 1 is not in the scene", skinned_triangle,
         [](Gltf& g) { g.json["skins"][0]["joints"][1] = 77; }},
        {"the file has no 'skins' with index 5", skinned_triangle,
         [](Gltf& g) { g.json["nodes"][0]["skin"] = 5; }},
    };
    for (const Case& spoiled : cases) {
        Gltf gltf = spoiled.make();
        spoiled.spoil(gltf);
        const auto scene = load_glb(gltf);
        ASSERT_TRUE(scene) << said(scene);
        EXPECT_TRUE(says(scene, spoiled.said));
        EXPECT_TRUE(says(scene, "mesh 'mesh' is shown as stored"));
        EXPECT_EQ(scene->triangle_count(), 1U);
    }
}

}  // namespace balcony::scene::testing::motion_test
