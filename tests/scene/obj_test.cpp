// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include "scene_files.hpp"

namespace balcony::scene::testing {

namespace {

using Obj = SceneFiles;

const char* const square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

const Material& material_of(const Scene& scene, std::size_t mesh) {
    return scene.materials[scene.meshes[mesh].material.value()];
}

}  // namespace

TEST_F(Obj, PolygonsAreTriangulated) {
    const auto scene = load_obj(std::string(square) + "f 1 2 3 4\n");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->format, "Wavefront OBJ");
    EXPECT_EQ(scene->axes, Axes::y_up);
    EXPECT_EQ(scene->triangle_count(), 2U);
    EXPECT_EQ(scene->bounds().max, V3f(1, 1, 0));
    ASSERT_EQ(scene->objects.size(), 1U);
    EXPECT_EQ(scene->objects[0].name, "scene") << "named by the file";
    EXPECT_TRUE(scene->default_light);
    EXPECT_TRUE(scene.diagnostics.empty()) << said(scene);
}

TEST_F(Obj, BottomLeftIsTurnedToTopLeft) {
    const auto scene = load_obj(std::string(square) +
                                "vt 0 1\nvt 1 0\nvt 0.5 0.25\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1\n");
    ASSERT_TRUE(scene) << said(scene);
    const Mesh& mesh = scene->meshes[0];
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const V2f expected = mesh.positions[i] == V3f(0, 0, 0)   ? V2f(0.0F, 0.0F)
                             : mesh.positions[i] == V3f(1, 0, 0) ? V2f(1.0F, 1.0F)
                                                                 : V2f(0.5F, 0.75F);
        EXPECT_EQ(mesh.texture_coordinates[i], expected);
    }
}

TEST_F(Obj, ObjectsAndMaterialsSplitMeshes) {
    write("a.mtl", "newmtl red paint\nKd 1 0 0\nKe 2 1 0\nd 0.5\nnewmtl shiny\nPr 0.1\nPm 1\n");
    const auto scene = load_obj("mtllib a.mtl\n" + std::string(square) +
                                "o left wall\nusemtl red paint\nf 1 2 3\nusemtl shiny\nf 1 3 4\n"
                                "g ignored\no right\nf 1 2 4\no left wall\nf 2 3 4\n");
    ASSERT_TRUE(scene) << said(scene);
    ASSERT_EQ(scene->objects.size(), 2U);
    EXPECT_EQ(scene->objects[0].name, "left wall");
    EXPECT_EQ(scene->objects[1].name, "right");
    EXPECT_EQ(scene->triangle_count(), 4U);
    std::size_t of_left = 0;
    for (const Instance& instance : scene->instances) {
        of_left += instance.object == 0 ? scene->meshes[instance.mesh.value()].triangles.size() : 0;
    }
    EXPECT_EQ(of_left, 3U) << "an object that goes on later is the same object";
    const Material& paint = material_of(*scene, 0);
    EXPECT_EQ(paint.name, "red paint");
    EXPECT_EQ(paint.base_color, Color3f(1.0F, 0.0F, 0.0F));
    EXPECT_EQ(paint.emission, Color3f(2.0F, 1.0F, 0.0F));
    EXPECT_EQ(paint.alpha, 0.5F);
    EXPECT_EQ(paint.alpha_mode, AlphaMode::blend);
    EXPECT_EQ(paint.metallic, 0.0F);
    EXPECT_TRUE(paint.double_sided);
    EXPECT_EQ(material_of(*scene, 1).roughness, 0.1F);
    EXPECT_EQ(material_of(*scene, 1).metallic, 1.0F);
    EXPECT_FALSE(scene->default_light);
}

TEST_F(Obj, GroupsNameObjectsInFilesWithoutObjectNames) {
    const auto scene = load_obj(std::string(square) + "g one\nf 1 2 3\ng two\nf 1 3 4\n");
    ASSERT_TRUE(scene) << said(scene);
    ASSERT_EQ(scene->objects.size(), 2U);
    EXPECT_EQ(scene->objects[1].name, "two");
}

TEST_F(Obj, MissingNormalsAreSmoothUpToAnAngle) {
    // A fold of 20 degrees along y, and one of 90.
    for (const double degrees : {20.0, 90.0}) {
        const double angle = degrees * std::acos(-1.0) / 180.0;
        const auto scene =
            load_obj("v 0 0 0\nv 0 1 0\nv -1 0 0\nv " + std::to_string(std::cos(angle)) + " 0 " +
                     std::to_string(-std::sin(angle)) + "\nf 1 2 3\nf 1 4 2\n");
        ASSERT_TRUE(scene) << said(scene);
        const std::size_t shared = scene->meshes[0].positions.size();
        EXPECT_EQ(shared, degrees < 45.0 ? 4U : 6U) << degrees;
    }
}

TEST_F(Obj, NegativeIndicesCountBackwards) {
    const auto scene = load_obj("v 9 9 9\n" + std::string(square) + "f -4 -3 -2\n");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->bounds().max, V3f(1, 1, 0));
}

TEST_F(Obj, TexturesAreFoundBesideTheLibrary) {
    std::filesystem::create_directory(directory / "maps");
    write("maps/wood grain.png", "");
    write("maps/m.mtl",
          "newmtl wood\nmap_Kd -clamp on -s 1 1 1 wood grain.png\n"
          "newmtl lost\nKd 0.5 0.5 0.5\nmap_Kd lost.png\n");
    const auto scene = load_obj("mtllib maps\\m.mtl\n" + std::string(square) +
                                "usemtl wood\nf 1 2 3\nusemtl lost\nf 1 3 4\n");
    ASSERT_TRUE(scene) << said(scene);
    ASSERT_EQ(scene->textures.size(), 1U);
    EXPECT_EQ(scene->textures[0].file, directory / "maps" / "wood grain.png");
    EXPECT_EQ(scene->textures[0].wrap_u, Wrap::clamp);
    EXPECT_TRUE(says(scene, "material 'lost': there is no texture file '"));
    EXPECT_EQ(material_of(*scene, 1).base_color, Color3f(0.5F));
}

TEST_F(Obj, MissingLibraryAndMaterialAreNamed) {
    write("b.mtl", "newmtl stone\n");
    const auto scene =
        load_obj("mtllib a.mtl\nmtllib b.mtl\n" + std::string(square) + "usemtl stoen\nf 1 2 3\n");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(says(scene, "material library skipped: there is no file '"));
    EXPECT_TRUE(says(scene, "material 'stoen' is in no material library"));
    EXPECT_TRUE(says(scene, "did you mean 'stone'?"));
}

TEST_F(Obj, BadFacesAreCounted) {
    const auto scene = load_obj(std::string(square) +
                                "v nan 0 0\nv 1e99 0 0\nf 1 2 3\nf 1 2 7\nf 0 1 2\nf 1/1 2/1 3/1\n"
                                "f 1 2 5\nf 1 2 6\nf 1 2\nl 1 2\np 1\n");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->triangle_count(), 1U);
    EXPECT_TRUE(says(scene, "3 faces skipped because of a vertex index out of range"));
    EXPECT_TRUE(says(scene, "2 faces skipped because of a vertex that is not finite or too large"));
    EXPECT_TRUE(says(scene, "1 face skipped with fewer than 3"));
    EXPECT_TRUE(says(scene, "2 point, line or curve statements skipped"));
}

TEST_F(Obj, FacesWithAndWithoutNormalsMix) {
    const auto scene = load_obj(std::string(square) +
                                "vn 0 0 -1\nvt 0 0\nf 1//1 2//1 3//1\nf 1/1 3/1 4/1\nf 1 2 4\n");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->triangle_count(), 3U);
    for (const Mesh& mesh : scene->meshes) {
        ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    }
}

TEST_F(Obj, LinesMayContinueAndEndAnyWay) {
    const auto scene = load_obj("# a comment \\\nv 0 0 0\r\nv 1 \\\n 0 0\r\nv 0 1 0\nf 1 2 \\\n3");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->triangle_count(), 1U);
}

TEST_F(Obj, BytesNeedNoFile) {
    const std::string text = std::string(square) + "f 1 2 3 4\n";
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    const auto scene = load("nowhere/square.obj", bytes);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->triangle_count(), 2U);
    EXPECT_EQ(scene->name, "nowhere/square.obj");
    EXPECT_FALSE(load("square.glb", bytes));
}

}  // namespace balcony::scene::testing
