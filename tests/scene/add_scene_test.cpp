// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "balcony/motion.hpp"
#include "balcony/scene.hpp"

namespace balcony::scene::add_scene_test {

namespace {

// A textured triangle, a light, a camera, and a node that moves the triangle to (0, t, 0).
Scene moving_triangle(Axes axes) {
    Scene scene;
    scene.axes = axes;
    scene.default_light = false;
    scene.textures.push_back({"paint", "paint.png", {}, Wrap::repeat, Wrap::repeat});
    Material material;
    material.base_color_texture.index = TextureIndex(0);
    scene.materials.push_back(material);
    Mesh mesh;
    mesh.positions = {V3f(0, 0, 0), V3f(1, 0, 0), V3f(0, 2, 0)};
    mesh.triangles = {{0, 1, 2}};
    mesh.material = MaterialIndex(0);
    scene.meshes.push_back(mesh);
    scene.objects.push_back({"triangle"});
    scene.instances.push_back({MeshIndex(0), M44d(), 0});
    Light light;
    light.kind = LightKind::spot;
    light.position = V3d(1, 2, 3);
    light.direction = V3d(0, 1, 0);
    scene.lights.push_back(light);
    Camera camera;
    camera.position = V3d(1, 2, 3);
    camera.up = V3d(0, 1, 0);
    scene.cameras.push_back(camera);
    scene.files = {"triangle.glb"};

    Motion motion;
    motion.tracks.push_back({Interpolation::linear, 3, {0.0, 1.0}, {0, 0, 0, 0, 1, 0}});
    Node node;
    node.translation_track = TrackIndex(0);
    motion.nodes.push_back(node);
    motion.animations.push_back({"rise", 1.0, 1});
    motion.instances.push_back({0, NodeIndex(0)});
    scene.motion = std::make_shared<const Motion>(std::move(motion));
    return scene;
}

V3d first_corner(const Scene& scene, std::size_t instance) {
    const Instance& placed = scene.instances[instance];
    return V3d(scene.meshes[placed.mesh.value()]->positions[2]) * placed.world_from_mesh;
}

TEST(AddScene, PartsReferToTheirOwn) {
    Scene scene = moving_triangle(Axes::y_up);
    Scene added = moving_triangle(Axes::y_up);
    added.textures[0].name = "other paint";
    added.meshes[0].edit().positions[2].y = 5;
    add_scene(scene, added);
    ASSERT_EQ(scene.instances.size(), 2U);
    const Instance& placed = scene.instances[1];
    const Mesh& mesh = scene.meshes.at(placed.mesh.value());
    EXPECT_EQ(mesh.positions[2].y, 5);
    const Material& material = scene.materials.at(mesh.material.value());
    EXPECT_EQ(scene.textures.at(material.base_color_texture.index.value()).name, "other paint");
    EXPECT_EQ(placed.object, 1U);
    EXPECT_EQ(scene.objects.size(), 2U);
    EXPECT_EQ(scene.lights.size(), 2U);
    EXPECT_EQ(scene.cameras.size(), 2U);
    EXPECT_EQ(scene.files.size(), 2U);
    EXPECT_FALSE(material.normal_texture.index.valid());
}

TEST(AddScene, OtherAxesAreTurned) {
    Scene scene = moving_triangle(Axes::z_up);
    add_scene(scene, moving_triangle(Axes::y_up));
    EXPECT_EQ(first_corner(scene, 0), V3d(0, 2, 0));
    EXPECT_EQ(first_corner(scene, 1), V3d(0, 0, 2));
    EXPECT_EQ(scene.lights[1].position, V3d(1, -3, 2));
    EXPECT_EQ(scene.lights[1].direction, V3d(0, 0, 1));
    EXPECT_EQ(scene.cameras[1].position, V3d(1, -3, 2));
    EXPECT_EQ(scene.cameras[1].up, V3d(0, 0, 1));
}

TEST(AddScene, BothKeepMoving) {
    Scene scene = moving_triangle(Axes::z_up);
    add_scene(scene, moving_triangle(Axes::y_up));
    scene = *moved_to(scene, 0.5);
    EXPECT_EQ(first_corner(scene, 0), V3d(0, 2.5, 0));
    EXPECT_EQ(first_corner(scene, 1), V3d(0, 0, 2.5));
}

TEST(AddScene, ALightInEitherReplacesTheDefault) {
    Scene dark;
    dark.default_light = true;
    Scene scene = dark;
    add_scene(scene, dark);
    EXPECT_TRUE(scene.default_light);
    add_scene(scene, moving_triangle(Axes::y_up));
    EXPECT_FALSE(scene.default_light);
}

}  // namespace

}  // namespace balcony::scene::add_scene_test
