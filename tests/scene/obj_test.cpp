// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include "scene_files.hpp"

namespace balcony::scene::testing::obj_test {

namespace {

using Obj = SceneFiles;

const char* const square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

const Material& material_of(const Scene& scene, std::size_t mesh) {
    return scene.materials[scene.meshes[mesh]->material.value()];
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

TEST_F(Obj, AByteOrderMarkIsNoPartOfTheFirstStatement) {
    const auto scene = load_obj("\xef\xbb\xbf" + std::string(square) + "f 1 2 3 4\n");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->triangle_count(), 2U);
    EXPECT_EQ(scene->bounds().max, V3f(1, 1, 0));
    EXPECT_TRUE(scene.diagnostics.empty()) << said(scene);
}

TEST_F(Obj, Utf16IsNamed) {
    for (const bool big_endian : {false, true}) {
        for (const bool marked : {false, true}) {
            std::string wide = !marked ? "" : big_endian ? "\xfe\xff" : "\xff\xfe";
            for (const char c : std::string(square) + "f 1 2 3\n") {
                wide += big_endian ? std::string{'\0', c} : std::string{c, '\0'};
            }
            const auto scene = load_obj(wide);
            ASSERT_FALSE(scene);
            EXPECT_NE(said(scene).find("UTF-16"), std::string::npos) << said(scene);
        }
    }
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
        EXPECT_EQ(mesh.texture_coordinates[0][i], expected);
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
        of_left +=
            instance.object == 0 ? scene->meshes[instance.mesh.value()]->triangles.size() : 0;
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
        const std::size_t shared = scene->meshes[0]->positions.size();
        EXPECT_EQ(shared, degrees < 45.0 ? 4U : 6U) << degrees;
    }
}

// Two faces with a fold of 90 degrees along y.
const char* const fold = "v 0 0 0\nv 0 1 0\nv -1 0 0\nv 0 0 -1\n";

TEST_F(Obj, SmoothingGroupsDecideWhichEdgesAreSmooth) {
    const auto vertices = [&](const std::string& faces) {
        const auto scene = load_obj(fold + faces);
        EXPECT_TRUE(scene) << said(scene);
        std::size_t count = 0;
        for (std::size_t i = 0; scene && i < scene->meshes.size(); ++i) {
            count += scene->meshes[i]->positions.size();
        }
        return count;
    };
    EXPECT_EQ(vertices("s 3\nf 1 2 3\nf 1 4 2\n"), 4U) << "one group is smooth at any angle";
    EXPECT_EQ(vertices("s 1\nf 1 2 3\ns 2\nf 1 4 2\n"), 6U) << "two groups";
    EXPECT_EQ(vertices("s off\nf 1 2 3\nf 1 3 2\n"), 6U) << "off is flat";
    EXPECT_EQ(vertices("s 0\nf 1 2 3\nf 1 3 2\n"), 6U) << "0 is flat";
}

// The normal at the common edge of two faces is halfway between them, whatever their materials are.
TEST_F(Obj, SmoothEdgesReachAcrossMaterialsButNotObjects) {
    write("a.mtl", "newmtl red\nnewmtl blue\n");
    const auto edge_normal = [&](const std::string& between) {
        const auto scene = load_obj("mtllib a.mtl\no a\nusemtl red\n" + std::string(fold) +
                                    "s 1\nf 1 2 3\n" + between + "f 1 4 2\n");
        EXPECT_TRUE(scene) << said(scene);
        EXPECT_EQ(scene->meshes.size(), 2U);
        const Mesh& mesh = scene->meshes[0];
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            if (mesh.positions[i] == V3f(0, 1, 0)) {
                return mesh.normals[i];
            }
        }
        return V3f(0.0F);
    };
    // The faces have the normals (0, 0, 1) and (1, 0, 0).
    EXPECT_NEAR(edge_normal("usemtl blue\n").dot(V3f(1, 0, 1).normalized()), 1.0F, 1e-6F);
    EXPECT_NEAR(edge_normal("o b\n").z, 1.0F, 1e-6F);
}

// A cone's tip, where many faces meet: its normal is the axis for any number of faces, also where
// one of them is cut in two.
TEST_F(Obj, NormalsDoNotDependOnTheTriangulation) {
    const char* const corners = "v 0 0 3\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 0.5 0.5 0\ns 1\n";
    const auto tip = [&](const std::string& faces) {
        const auto scene = load_obj(corners + faces);
        EXPECT_TRUE(scene) << said(scene);
        const Mesh& mesh = scene->meshes[0];
        const auto at = std::find(mesh.positions.begin(), mesh.positions.end(), V3f(0, 0, 3));
        return mesh.normals[static_cast<std::size_t>(at - mesh.positions.begin())];
    };
    const std::string others = "f 1 3 4\nf 1 4 5\nf 1 5 2\n";
    for (const V3f& normal : {tip("f 1 2 3\n" + others), tip("f 1 2 6\nf 1 6 3\n" + others)}) {
        EXPECT_NEAR((normal - V3f(0, 0, 1)).length(), 0.0F, 1e-6F) << normal;
    }
}

TEST_F(Obj, SharedCornersAreOneVertex) {
    const auto scene = load_obj(std::string(square) +
                                "vn 0 0 1\nvt 0 0\nvt 1 1\n"
                                "f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/2/1\n");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->meshes[0]->positions.size(), 4U);
}

TEST_F(Obj, ConcavePolygonsKeepTheirShape) {
    // An arrowhead: a fan about its first corner would cover the notch.
    const auto scene = load_obj("v 0 2 0\nv -2 -2 0\nv 0 -1 0\nv 2 -2 0\nf 2 3 4 1\nf 1 2 3 4\n");
    ASSERT_TRUE(scene) << said(scene);
    const Mesh& mesh = scene->meshes[0];
    ASSERT_EQ(mesh.triangles.size(), 4U);
    for (const auto& [a, b, c] : mesh.triangles) {
        const V3f area =
            (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
        EXPECT_FLOAT_EQ(area.z, 6.0F) << "each half of the arrowhead";
    }
}

TEST_F(Obj, VertexColorsBecomeLinear) {
    const auto scene = load_obj("v 0 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0 2 0 0\nf 1 2 3\n");
    ASSERT_TRUE(scene) << said(scene);
    const Mesh& mesh = scene->meshes[0];
    ASSERT_EQ(mesh.colors.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const V3f& at = mesh.positions[i];
        const Color3f expected = at.x > 0.0F   ? Color3f(1.0F, 0.21404114F, 0.0F)
                                 : at.y > 0.0F ? Color3f(1.0F, 0.0F, 0.0F)
                                               : Color3f(1.0F);
        const Color3f color(mesh.colors[i].r, mesh.colors[i].g, mesh.colors[i].b);
        EXPECT_NEAR((color - expected).length(), 0.0F, 1e-6F) << i;
        EXPECT_EQ(mesh.colors[i].a, 1.0F);
    }
}

// The material of a library.
class Mtl : public SceneFiles {
protected:
    [[nodiscard]] Result<Scene> load_with(const std::string& statements) const {
        write("a.mtl", "newmtl m\n" + statements);
        write("t.png", "");
        write("u.png", "");
        return load_obj("mtllib a.mtl\n" + std::string(square) + "usemtl m\nf 1 2 3\n");
    }
    [[nodiscard]] Material material(const std::string& statements) const {
        const auto scene = load_with(statements);
        EXPECT_TRUE(scene) << said(scene);
        EXPECT_TRUE(scene.diagnostics.empty()) << said(scene);
        return scene ? material_of(*scene, 0) : Material();
    }
};

TEST_F(Mtl, ThePbrExtensionIsRead) {
    const Material m = material("Pr 0.25\nPm 0.5\nPc 0.75\nPcr 0.125\nPs 0.5\nNi 1.25\n");
    EXPECT_EQ(m.roughness, 0.25F);
    EXPECT_EQ(m.metallic, 0.5F);
    EXPECT_EQ(m.clearcoat, 0.75F);
    EXPECT_EQ(m.clearcoat_roughness, 0.125F);
    EXPECT_EQ(m.sheen_color, Color3f(0.5F));
    EXPECT_EQ(m.ior, 1.25F);
}

// Models 3, 5 and 8 reflect Ks at normal incidence; 0 and 1 have no highlight.
TEST_F(Mtl, IlluminationModelsReflect) {
    const Color3f ks(0.5F, 0.25F, 1.0F);
    for (const char* model : {"3", "5", "8"}) {
        const Material mirror =
            material(std::string("Kd 0 0 0\nKs 0.5 0.25 1\nillum ") + model + "\n");
        const float from_front = std::pow((mirror.ior - 1.0F) / (mirror.ior + 1.0F), 2.0F);
        EXPECT_TRUE((from_front * mirror.specular_color).equalWithAbsError(ks, 1e-6F)) << model;
    }
    EXPECT_EQ(material("illum 3\n").roughness, 0.0F) << "reflections are sharp";
    EXPECT_GT(material("illum 3\nNs 100\n").roughness, 0.3F);
    EXPECT_EQ(material("illum 1\n").specular, 0.0F);
    EXPECT_EQ(material("illum 2\nKs 0.5 0.5 0.5\n").specular_color, Color3f(1.0F));
}

TEST_F(Mtl, IlluminationModelsTransmit) {
    const Material glass = material("Kd 0 0 0\nTf 1 0.5 0.25\nNi 1.33\nillum 7\n");
    EXPECT_EQ(glass.transmission, 1.0F);
    EXPECT_FALSE(glass.thin_walled);
    EXPECT_EQ(glass.base_color, Color3f(1.0F, 0.5F, 0.25F));
    EXPECT_EQ(glass.ior, 1.33F);
    EXPECT_EQ(glass.roughness, 0.0F);
    const Material pane = material("d 0.25\nillum 4\n");
    EXPECT_EQ(pane.transmission, 0.75F);
    EXPECT_TRUE(pane.thin_walled);
    EXPECT_EQ(pane.alpha_mode, AlphaMode::opaque) << "its d is not a cut-out";
    const Material blended = material("d 0.25\nillum 9\n");
    EXPECT_EQ(blended.transmission, 0.0F);
    EXPECT_EQ(blended.alpha, 0.25F);
}

TEST_F(Mtl, MapsHaveTheirMeaning) {
    const Material m = material(
        "map_Kd t.png\nmap_Ke t.png\nmap_d -imfchan g u.png\nmap_Pr u.png\nmap_Pm u.png\n"
        "norm -bm 0.5 t.png\n");
    EXPECT_EQ(m.base_color, Color3f(1.0F)) << "without Kd, the map alone";
    EXPECT_EQ(m.emission, Color3f(1.0F));
    EXPECT_EQ(m.metallic, 1.0F);
    EXPECT_EQ(m.base_color_texture.encoding, TextureEncoding::srgb);
    EXPECT_EQ(m.roughness_texture.encoding, TextureEncoding::linear);
    EXPECT_EQ(m.opacity_texture.channel, 1);
    EXPECT_EQ(m.alpha_mode, AlphaMode::blend);
    EXPECT_NE(m.opacity_texture.index, m.base_color_texture.index);
    EXPECT_EQ(m.normal_scale, 0.5F);
    EXPECT_EQ(material("map_Kd t.png\nmap_d t.png\n").opacity_texture.channel, 3);
}

// OBJ's (u, v), with v up, becomes offset + scale (u, v).
TEST_F(Mtl, MapsAreMovedAndScaled) {
    const TextureUse use = material("map_Kd -s 2 3 1 -o 0.25 0.5 t.png\n").base_color_texture;
    for (const V2f& at : {V2f(0.0F, 0.0F), V2f(0.5F, 0.25F)}) {
        const V2f placed = use.place({at.x, 1.0F - at.y});
        EXPECT_EQ(placed, V2f(0.25F + 2.0F * at.x, 1.0F - (0.5F + 3.0F * at.y)));
    }
}

TEST_F(Mtl, WhatIsIgnoredIsReported) {
    const auto scene = load_with("map_Bump t.png\nmap_Ns t.png\n");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(says(scene, "material 'm': 'map_Bump' is not supported"));
    EXPECT_TRUE(says(scene, "a normal map is stated by 'norm'"));
    EXPECT_TRUE(says(scene, "material 'm': 'map_Ns' is not supported"));
}

TEST_F(Mtl, StatementsOutOfRangeAreReported) {
    const auto scene = load_with("Ke 1e40 0 0\nKd -1 0 0\n");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(material_of(*scene, 0).emission, Color3f(0.0F));
    EXPECT_TRUE(
        says(scene, "material 'm': 'Ke' is ignored: its numbers are missing or out of range"));
    EXPECT_TRUE(
        says(scene, "material 'm': 'Kd' is ignored: its numbers are missing or out of range"));
}

TEST_F(Obj, FilesOfTheSceneAreNamed) {
    write("a.mtl", "newmtl m\nmap_Kd lost.png\n");
    const auto scene = load_obj("mtllib a.mtl\n" + std::string(square) + "usemtl m\nf 1 2 3\n");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->files, (std::vector<std::filesystem::path>{
                                folder / "a.mtl", folder / "lost.png", folder / "scene.obj"}));
}

TEST_F(Obj, NegativeIndicesCountBackwards) {
    const auto scene = load_obj("v 9 9 9\n" + std::string(square) + "f -4 -3 -2\n");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->bounds().max, V3f(1, 1, 0));
}

TEST_F(Obj, TexturesAreFoundBesideTheLibrary) {
    std::filesystem::create_directory(folder / "maps");
    write("maps/wood grain.png", "");
    write("maps/m.mtl",
          "newmtl wood\nmap_Kd -clamp on -s 1 1 1 wood grain.png\n"
          "newmtl lost\nKd 0.5 0.5 0.5\nmap_Kd lost.png\n");
    const auto scene = load_obj("mtllib maps\\m.mtl\n" + std::string(square) +
                                "usemtl wood\nf 1 2 3\nusemtl lost\nf 1 3 4\n");
    ASSERT_TRUE(scene) << said(scene);
    ASSERT_EQ(scene->textures.size(), 1U);
    EXPECT_EQ(scene->textures[0].file, folder / "maps" / "wood grain.png");
    EXPECT_EQ(scene->textures[0].wrap_u, Wrap::clamp);
    EXPECT_TRUE(says(scene, "material 'lost': its texture is skipped: there is no file '"));
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
                                "f 1 2 5\nf 1 2 6\nf 1 2 3x\nf 1/1/1/1 2 3\nf 1 2\nl 1 2\np 1\n");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->triangle_count(), 1U);
    EXPECT_TRUE(says(scene, "5 faces skipped because of a vertex index out of range"));
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

}  // namespace balcony::scene::testing::obj_test
