// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <numbers>

#include "scene_files.hpp"

namespace balcony::scene::testing::camera_test {

namespace {

class Cameras : public SceneFiles {
protected:
    [[nodiscard]] static Gltf with_camera(const Json& camera, Json node) {
        Gltf gltf = one_triangle();
        gltf.json["cameras"] = {camera};
        node["camera"] = 0;
        gltf.add_node(node);
        return gltf;
    }

    [[nodiscard]] static Json perspective(const Json& values) {
        return {{"type", "perspective"}, {"perspective", values}};
    }
};

// Directions are made of a few products of numbers near one.
constexpr double rounding = 1e-12;

bool equal(const V3d& a, const V3d& b) { return a.equalWithAbsError(b, rounding); }

}  // namespace

TEST_F(Cameras, FollowTheirNodes) {
    const double half = std::sqrt(0.5);
    // A quarter turn about x takes -z to +y and +y to +z. The scale has no effect.
    const auto scene = load_glb(with_camera(
        perspective({{"yfov", 1.2}, {"aspectRatio", 1.5}, {"znear", 0.25}, {"zfar", 100}}),
        {{"name", "Eye"},
         {"translation", {1, 2, 3}},
         {"rotation", {half, 0, 0, half}},
         {"scale", {3, 2, 5}}}));
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(scene.diagnostics.empty()) << said(scene);
    ASSERT_EQ(scene->cameras.size(), 1U);
    const Camera& camera = scene->cameras[0];
    EXPECT_EQ(camera.name, "Eye");
    EXPECT_EQ(camera.projection, Projection::perspective);
    EXPECT_EQ(camera.position, V3d(1, 2, 3));
    EXPECT_TRUE(equal(camera.forward, V3d(0, 1, 0)));
    EXPECT_TRUE(equal(camera.up, V3d(0, 0, 1)));
    EXPECT_TRUE(equal(camera.right, V3d(1, 0, 0)));
    EXPECT_NEAR(camera.half_height, std::tan(0.6), rounding);
    EXPECT_EQ(camera.aspect, 1.5);
    EXPECT_EQ(camera.near, 0.25);
}

TEST_F(Cameras, MayBeOrthographic) {
    const auto scene = load_glb(
        with_camera({{"type", "orthographic"},
                     {"name", "Plan"},
                     {"orthographic", {{"xmag", 6}, {"ymag", 4}, {"znear", 0}, {"zfar", 10}}}},
                    Json::object()));
    ASSERT_TRUE(scene) << said(scene);
    ASSERT_EQ(scene->cameras.size(), 1U);
    const Camera& camera = scene->cameras[0];
    EXPECT_EQ(camera.name, "Plan") << "the node has no name";
    EXPECT_EQ(camera.projection, Projection::orthographic);
    EXPECT_EQ(camera.half_height, 4.0);
    EXPECT_EQ(camera.aspect, 1.5);
    EXPECT_TRUE(equal(camera.forward, V3d(0, 0, -1)));
}

TEST_F(Cameras, OfMirroredNodesAreMirrored) {
    const auto scene = load_glb(with_camera(perspective({{"yfov", 1}}), {{"scale", {-1, 1, 1}}}));
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(equal(scene->cameras.at(0).right, V3d(-1, 0, 0)));
}

TEST_F(Cameras, ThatAreBrokenAreSkippedByName) {
    const Json orthographic{{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 0}}}};
    const std::vector<std::pair<Json, std::string>> broken = {
        {perspective({{"yfov", 0}}), "'yfov'"},
        {perspective({{"yfov", -1}}), "'yfov'"},
        {perspective({{"yfov", "wide"}}), "'yfov'"},
        {perspective({{"yfov", std::numbers::pi}}), "'yfov'"},
        {perspective({{"yfov", 1}, {"aspectRatio", 0}}), "'aspectRatio'"},
        {{{"type", "perspective"}}, "'yfov'"},
        {orthographic, "'ymag'"},
        {{{"type", "fisheye"}}, "'fisheye'"},
        {Json::array(), "type"},
    };
    for (const auto& [camera, reason] : broken) {
        const auto scene = load_glb(with_camera(camera, {{"name", "Bad"}}));
        ASSERT_TRUE(scene) << said(scene);
        EXPECT_TRUE(scene->cameras.empty()) << camera;
        EXPECT_TRUE(says(scene, "camera 'Bad' is skipped")) << said(scene);
        EXPECT_TRUE(says(scene, reason)) << said(scene);
    }
    Gltf flat = with_camera(perspective({{"yfov", 1}}), {{"name", "Bad"}, {"scale", {1, 0, 0}}});
    EXPECT_TRUE(says(load_glb(flat), "no direction"));
    Gltf missing = with_camera(perspective({{"yfov", 1}}), {{"name", "Bad"}});
    missing.json["nodes"].back()["camera"] = 7;
    EXPECT_TRUE(says(load_glb(missing), "camera 'Bad' is skipped"));
}

}  // namespace balcony::scene::testing::camera_test
