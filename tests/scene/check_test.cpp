// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Scenes that programs make: each way in which one may not be consistent.

#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "balcony/scene.hpp"

namespace balcony::scene::check_test {
namespace {

Scene triangle() {
    Mesh mesh;
    mesh.positions = {{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}};
    mesh.triangles = {{0, 1, 2}};
    mesh.material = MaterialIndex(0);
    Scene scene;
    scene.meshes.emplace_back(mesh);
    scene.materials.emplace_back();
    scene.objects.push_back({"triangle"});
    scene.instances.push_back({.mesh = MeshIndex(0), .world_from_mesh = {}});
    return scene;
}

using Change = std::function<void(Scene&)>;

TEST(SceneCheck, NamesThePartThatDoesNotFit) {
    const std::vector<std::pair<const char*, Change>> changes{
        {"mesh 0", [](Scene& s) { s.meshes[0].edit().material = {}; }},
        {"mesh 0", [](Scene& s) { s.meshes[0].edit().material = MaterialIndex(1); }},
        {"mesh 0", [](Scene& s) { s.meshes[0].edit().triangles[0][2] = 3; }},
        {"mesh 0", [](Scene& s) { s.meshes[0].edit().normals.resize(2); }},
        {"mesh 0", [](Scene& s) { s.meshes[0].edit().tangents.resize(4); }},
        {"mesh 0", [](Scene& s) { s.meshes[0].edit().colors.resize(1); }},
        {"mesh 0", [](Scene& s) { s.meshes[0].edit().texture_coordinates[1].resize(1); }},
        {"material 0", [](Scene& s) { s.materials[0].normal_texture.index = TextureIndex(0); }},
        {"material 0",
         [](Scene& s) {
             s.textures.emplace_back();
             s.materials[0].roughness_texture = {.index = TextureIndex(0), .channel = 4};
         }},
        {"instance 0", [](Scene& s) { s.instances[0].mesh = {}; }},
        {"instance 0", [](Scene& s) { s.instances[0].mesh = MeshIndex(1); }},
        {"instance 0", [](Scene& s) { s.instances[0].object = 1; }},
    };
    EXPECT_TRUE(check(triangle()).empty());
    EXPECT_FALSE(to_glb(triangle()).empty());
    for (std::size_t i = 0; i < changes.size(); ++i) {
        Scene scene = triangle();
        changes[i].second(scene);
        const Diagnostics found = check(scene);
        ASSERT_EQ(found.size(), 1U) << i;
        EXPECT_EQ(found[0].kind, Kind::internal);
        EXPECT_TRUE(found[0].message.starts_with(changes[i].first)) << i << found[0].message;
        EXPECT_THROW(static_cast<void>(to_glb(scene)), std::logic_error) << i;
    }
}

TEST(SceneCheck, AGlbFileHasItsTexturesInIt) {
    Scene scene = triangle();
    scene.textures.emplace_back().file = "beside.png";
    EXPECT_TRUE(check(scene).empty());
    EXPECT_THROW(static_cast<void>(to_glb(scene)), std::logic_error);
}

}  // namespace
}  // namespace balcony::scene::check_test
