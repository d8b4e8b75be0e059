// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// What is written as GLB, read back by the letter of the format and by our own reader.

#include <filesystem>
#include <fstream>
#include <iterator>

#include <Imath/ImathQuat.h>

#include "balcony/motion.hpp"
#include "balcony/scene.hpp"
#include "glb_file.hpp"

namespace balcony::scene::testing::write_glb_test {

namespace {

using Imath::V3d;
using Imath::V3f;

// One triangle, placed by a rotation and a translation, under one spot light.
scene::Scene small_scene() {
    scene::Scene scene;
    scene.axes = Axes::z_up;
    scene.materials.resize(1);
    scene::Mesh mesh;
    mesh.positions = {V3f(1, 2, 3), V3f(2, 2, 3), V3f(1, 4, 3)};
    mesh.normals = {V3f(0, 0, 1), V3f(0, 0, 1), V3f(0, 0, 1)};
    mesh.triangles = {{0, 1, 2}};
    mesh.material = scene::MaterialIndex(0);
    scene.meshes.push_back(mesh);
    scene.objects.push_back({"triangle"});
    Imath::M44d placed;
    placed.rotate(V3d(0.3, -0.5, 1.1));
    placed *= Imath::M44d().setTranslation(V3d(5, 6, 7));
    scene.instances.push_back({scene::MeshIndex(0), placed, 0});
    return scene;
}

scene::Light spot(const V3d& direction) {
    scene::Light light;
    light.name = "spot";
    light.kind = scene::LightKind::spot;
    light.position = V3d(1, 2, 3);
    light.direction = direction;
    light.intensity = scene::Color3f(30.0F, 60.0F, 15.0F);
    return light;
}

GlbFile written(const scene::Scene& scene) {
    GlbFile file;
    read_glb(to_glb(scene), file);
    return file;
}

// Whatever the interpolation, a written scene moves as the one in memory does, but for its axes and
// the precision of floats.
TEST(WriteGlb, KeepsTheMotionOfInstances) {
    scene::Scene scene = small_scene();
    scene.instances.push_back(scene.instances[0]);
    scene.instances[1].object = 1;
    scene.objects.push_back({"still"});
    Motion motion;
    motion.tracks.push_back({Interpolation::linear,
                             4,
                             {0.0, 1.0, 2.0},
                             {0, 0, 0, 1, 0.6F, 0, 0, 0.8F, 0, 0.8F, 0.6F, 0}});
    motion.tracks.push_back({Interpolation::step, 3, {0.5, 1.5}, {1, 2, 3, 4, 5, 6}});
    motion.tracks.push_back({Interpolation::cubic_spline,
                             3,
                             {0.0, 2.0},
                             {0, 0, 0, 1, 2, 3, 1, -1, 2, -2, 0, 1, 4, 2, 1, 0, 0, 0}});
    Node parent;
    parent.world_from_parent.rotate(V3d(0.2, 0.4, -0.3));
    parent.translation = V3d(1, 0, -2);
    parent.rotation_track = TrackIndex(0);
    Node child;
    child.parent = NodeIndex(0);
    child.rotation = Imath::Quatd(0.6, V3d(0, 0.8, 0));
    child.translation_track = TrackIndex(1);
    child.scale_track = TrackIndex(2);
    motion.nodes = {parent, child};
    motion.instances.push_back({0, NodeIndex(1)});
    motion.animations.push_back({"all", 2.0, 3});
    scene.motion = std::make_shared<const Motion>(motion);

    auto read = load("motion.glb", to_glb(scene));
    ASSERT_TRUE(read) << to_text(read.diagnostics);
    EXPECT_TRUE(read.diagnostics.empty()) << to_text(read.diagnostics);
    ASSERT_EQ(read->instances.size(), 2U);
    for (const double time : {0.0, 0.3, 0.9, 1.2, 1.7, 2.5}) {
        scene = *moved_to(scene, time);
        read = moved_to(*read, time);
        EXPECT_TRUE(read.diagnostics.empty());
        for (const scene::Instance& instance : read->instances) {
            const std::string& name = read->objects[instance.object].name;
            const scene::Instance& own = scene.instances[name == "still" ? 1 : 0];
            for (std::size_t i = 0; i < 3; ++i) {
                const V3d expected =
                    turned(V3d(scene.meshes[0]->positions[i]) * own.world_from_mesh, Axes::z_up,
                           Axes::y_up);
                const V3d found = V3d(read->meshes[instance.mesh.value()]->positions[i]) *
                                  instance.world_from_mesh;
                EXPECT_LT((found - expected).length(), 1e-5) << name << " at " << time;
            }
        }
    }
}

TEST(WriteGlb, TurnsZUpToYUp) {
    const GlbFile file = written(small_scene());
    const auto& attributes = file.document["meshes"][0]["primitives"][0]["attributes"];
    const auto positions = elements_of<V3f>(file, attributes["POSITION"].get<std::size_t>());
    const auto normals = elements_of<V3f>(file, attributes["NORMAL"].get<std::size_t>());
    EXPECT_EQ(positions[0], V3f(1, 3, -2));
    EXPECT_EQ(normals[0], V3f(0, 1, 0));
}

TEST(WriteGlb, PlacesAMeshWhereTheSceneDoes) {
    const scene::Scene scene = small_scene();
    const GlbFile file = written(scene);
    const auto vertices = vertices_z_up(file, file.document["nodes"][0]);
    ASSERT_EQ(vertices.size(), 3U);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const V3d expected =
            V3d(scene.meshes[0]->positions[i]) * scene.instances[0].world_from_mesh;
        // A few roundings of doubles of size 10.
        EXPECT_LT((vertices[i] - expected).length(), 1e-13);
    }
}

TEST(WriteGlb, KeepsYUpUnchanged) {
    scene::Scene scene = small_scene();
    scene.axes = Axes::y_up;
    const GlbFile file = written(scene);
    const auto& attributes = file.document["meshes"][0]["primitives"][0]["attributes"];
    EXPECT_EQ(elements_of<V3f>(file, attributes["POSITION"].get<std::size_t>())[0], V3f(1, 2, 3));
}

TEST(WriteGlb, StatesTheBoundsOfPositions) {
    const GlbFile file = written(small_scene());
    const auto& attributes = file.document["meshes"][0]["primitives"][0]["attributes"];
    const auto& accessor = file.document["accessors"][attributes["POSITION"].get<std::size_t>()];
    EXPECT_EQ(accessor["min"], nlohmann::json({1.0, 3.0, -4.0}));
    EXPECT_EQ(accessor["max"], nlohmann::json({2.0, 3.0, -2.0}));
}

TEST(WriteGlb, AimsASpotLight) {
    for (const V3d& direction :
         {V3d(0, 0, -1), V3d(0, 0, 1), V3d(0, 1, 0), V3d(0, -1, 0), V3d(0.36, 0.48, -0.8)}) {
        scene::Scene scene = small_scene();
        scene.lights.push_back(spot(direction));
        const GlbFile file = written(scene);
        const auto& node = file.document["nodes"].back();
        const auto& r = node["rotation"];
        const Imath::Quatd rotation(r[3], V3d(r[0], r[1], r[2]));
        const V3d shines = V3d(0, 0, -1) * rotation.toMatrix44();
        const V3d expected(direction.x, direction.z, -direction.y);
        // A few roundings of doubles of size 1.
        EXPECT_LT((shines - expected).length(), 1e-14) << direction;
        EXPECT_NEAR(rotation.length(), 1.0, 1e-14);
        EXPECT_EQ(node["translation"], nlohmann::json({1.0, 3.0, -2.0}));
    }
}

TEST(WriteGlb, KeepsALightsColorAndCandela) {
    scene::Scene scene = small_scene();
    scene.lights.push_back(spot(V3d(0, 0, -1)));
    const GlbFile file = written(scene);
    const auto& light = file.document["extensions"]["KHR_lights_punctual"]["lights"][0];
    EXPECT_EQ(light["intensity"], 60.0);
    EXPECT_EQ(light["color"], nlohmann::json({0.5, 1.0, 0.25}));
    EXPECT_EQ(light["type"], "spot");
    EXPECT_EQ(file.document["extensionsUsed"], nlohmann::json({"KHR_lights_punctual"}));
}

TEST(WriteGlb, KeepsColorsForOurOwnReader) {
    scene::Scene scene = small_scene();
    const std::vector<Color4f> colors{
        {1.0F, 0.5F, 0.0F, 1.0F}, {0.25F, 1.0F, 0.0F, 0.5F}, {0.0F, 0.0F, 0.125F, 0.0F}};
    scene.meshes[0].edit().colors = colors;
    const auto read = load("colors.glb", to_glb(scene));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->meshes[0]->colors, colors);
}

TEST(WriteGlb, KeepsTexturesThatAreNotInterpolated) {
    scene::Scene scene = small_scene();
    for (const bool interpolated : {true, false}) {
        Texture& texture = scene.textures.emplace_back();
        texture.bytes = std::vector<std::uint8_t>{0x89};
        texture.interpolated = interpolated;
    }
    const GlbFile file = written(scene);
    EXPECT_FALSE(file.document["samplers"][0].contains("magFilter"));
    EXPECT_EQ(file.document["samplers"][1]["magFilter"], 9728);
}

}  // namespace

}  // namespace balcony::scene::testing::write_glb_test
