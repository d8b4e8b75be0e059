// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include "scene_files.hpp"

namespace balcony::scene::testing::gltf_geometry_test {

namespace {

using GltfGeometry = SceneFiles;

// Matrices are made of products of numbers near one; their rounding stays well below this.
constexpr double rounding = 1e-12;

void expect_near(const V3d& actual, const V3d& expected) {
    EXPECT_LT((actual - expected).length(), rounding)
        << actual.x << " " << actual.y << " " << actual.z;
}

M44d translation(double x, double y, double z) {
    M44d matrix;
    matrix.setTranslation(V3d(x, y, z));
    return matrix;
}

}  // namespace

TEST_F(GltfGeometry, NestedTransformsAreTheProduct) {
    Gltf gltf;
    const std::size_t mesh = gltf.add_triangle("mesh");
    const double half = std::sqrt(0.5);
    // A quarter turn about y: +x goes to -z.
    gltf.add_node({{"name", "parent"},
                   {"rotation", {0, half, 0, half}},
                   {"translation", {10, 0, 0}},
                   {"children", {1}}});
    // The matrix is stored by columns: a translation by (1, 2, 3).
    gltf.add_node({{"name", "child"},
                   {"children", {2}},
                   {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1}}},
                  false);
    gltf.add_node({{"name", "leaf"}, {"mesh", mesh}, {"scale", {2, -3, 4}}}, false);
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    ASSERT_EQ(scene->instances.size(), 1U);
    const M44d& world_from_mesh = scene->instances[0].world_from_mesh;

    M44d scale;
    scale.setScale(V3d(2, -3, 4));
    const M44d turn(0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1);
    const M44d expected = scale * translation(1, 2, 3) * turn * translation(10, 0, 0);
    EXPECT_TRUE(world_from_mesh.equalWithAbsError(expected, rounding));
    // The same by hand: (1,0,0) is scaled to (2,0,0), moved to (3,2,3), turned to (3,2,-3).
    expect_near(V3d(1, 0, 0) * world_from_mesh, V3d(13, 2, -3));
    EXPECT_LT(world_from_mesh.determinant(), 0.0) << "a negative scale stays a mirror image";
    EXPECT_TRUE(scene.diagnostics.empty()) << said(scene);
}

TEST_F(GltfGeometry, NodesShareAMesh) {
    Gltf gltf;
    const std::size_t mesh = gltf.add_triangle("shared");
    gltf.add_node({{"name", "same"}, {"mesh", mesh}});
    gltf.add_node({{"name", "same"}, {"mesh", mesh}, {"translation", {0, 0, 5}}});
    gltf.add_node({{"mesh", mesh}, {"translation", {-2, 0, 0}}});
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->meshes.size(), 1U);
    ASSERT_EQ(scene->instances.size(), 3U);
    ASSERT_EQ(scene->objects.size(), 3U);
    EXPECT_EQ(scene->objects[0].name, "same");
    EXPECT_EQ(scene->objects[1].name, "same");
    EXPECT_EQ(scene->objects[2].name, "shared") << "a node without a name has the mesh's";
    EXPECT_EQ(scene->instances[1].object, 1U);
    expect_near(V3d(0.0) * scene->instances[1].world_from_mesh, V3d(0, 0, 5));
    EXPECT_EQ(scene->triangle_count(), 3U) << "instances count each";
    EXPECT_EQ(scene->bounds().min, V3f(-2, 0, 0));
    EXPECT_EQ(scene->bounds().max, V3f(1, 1, 5));
}

TEST_F(GltfGeometry, PrimitivesOfAMeshAreOneObject) {
    Gltf gltf = one_triangle();
    Json second = gltf.primitive(0);
    gltf.json["materials"] = {{{"name", "red"}}};
    second["material"] = 0;
    gltf.json["meshes"][0]["primitives"].push_back(second);
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    ASSERT_EQ(scene->instances.size(), 2U);
    EXPECT_EQ(scene->objects.size(), 1U);
    EXPECT_EQ(scene->instances[0].object, scene->instances[1].object);
    EXPECT_EQ(scene->materials[scene->meshes[1]->material.value()].name, "red");
}

TEST_F(GltfGeometry, StripsAndFansFaceOneSide) {
    for (const int mode : {5, 6}) {
        Gltf gltf = one_triangle();
        const bool strip = mode == 5;
        const std::vector<float> square =
            strip ? std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}
                  : std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
        gltf.json["meshes"][0]["primitives"] = {
            {{"attributes", {{"POSITION", gltf.add_floats(square, 3)}}}, {"mode", mode}}};
        const auto scene = load_glb(gltf);
        ASSERT_TRUE(scene) << said(scene);
        EXPECT_EQ(scene->triangle_count(), 2U);
        for (const V3f& normal : scene->meshes[0]->normals) {
            EXPECT_EQ(normal, V3f(0, 0, 1)) << "mode " << mode;
        }
    }
}

TEST_F(GltfGeometry, PointsAndLinesAreCounted) {
    Gltf gltf = one_triangle();
    for (const int mode : {0, 1, 2, 3, 3}) {
        Json other = gltf.primitive(0);
        other["mode"] = mode;
        gltf.json["meshes"][0]["primitives"].push_back(other);
    }
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->triangle_count(), 1U);
    EXPECT_TRUE(says(scene, "1 primitive of points skipped"));
    EXPECT_TRUE(says(scene, "4 primitives of lines skipped"));
}

TEST_F(GltfGeometry, MissingNormalsAreFlat) {
    // A roof: two triangles that share the edge along y.
    Gltf gltf = one_triangle();
    const std::size_t positions = gltf.add_floats({0, 0, 0, 0, 1, 0, 1, 0, -1, -1, 0, -1}, 3);
    const std::size_t indices = gltf.add_shorts({0, 2, 1, 0, 1, 3}, 1);
    gltf.json["meshes"][0]["primitives"] = {
        {{"attributes", {{"POSITION", positions}}}, {"indices", indices}}};
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    const Mesh& mesh = scene->meshes[0];
    ASSERT_EQ(mesh.normals.size(), 6U) << "corners are not shared";
    const float slope = std::sqrt(0.5F);
    constexpr float single_rounding = 1e-6F;
    for (std::size_t i = 0; i < 6; ++i) {
        const V3f expected(i < 3 ? slope : -slope, 0.0F, slope);
        EXPECT_TRUE(mesh.normals[i].equalWithAbsError(expected, single_rounding)) << i;
    }
}

// The triangle is tilted, so that the normal of its face differs from any default.
TEST_F(GltfGeometry, NormalsWithoutLengthAreTheFaces) {
    Gltf gltf = one_triangle();
    gltf.primitive(0)["attributes"] = {
        {"POSITION", gltf.add_floats({0, 0, 0, 3, 0, 4, 0, 1, 0}, 3)},
        {"NORMAL", gltf.add_floats({0, 0, 0, 0, 0, 7, std::nanf(""), 0, 1}, 3)}};
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    const std::vector<V3f>& normals = scene->meshes[0]->normals;
    ASSERT_EQ(normals.size(), 3U);
    constexpr float single_rounding = 1e-6F;
    const V3f faced(-0.8F, 0.0F, 0.6F);
    EXPECT_TRUE(normals[0].equalWithAbsError(faced, single_rounding)) << normals[0];
    EXPECT_EQ(normals[1], V3f(0, 0, 1)) << "a normal that has a length is kept";
    EXPECT_TRUE(normals[2].equalWithAbsError(faced, single_rounding)) << normals[2];
    EXPECT_TRUE(says(scene, "mesh 'mesh': 2 normals of length 0 replaced"));
}

TEST_F(GltfGeometry, TextureCoordinatesKeepTheTopLeftCorner) {
    Gltf gltf = one_triangle();
    gltf.primitive(0)["attributes"]["TEXCOORD_0"] = gltf.add_floats({0, 0, 1, 0, 0, 1}, 2);
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    const Mesh& mesh = scene->meshes[0];
    EXPECT_EQ(mesh.texture_coordinates[0], (std::vector<V2f>{{0, 0}, {1, 0}, {0, 1}}));
    EXPECT_EQ(mesh.positions[0], V3f(0, 0, 0));
}

TEST_F(GltfGeometry, IntegerTextureCoordinatesAreNormalized) {
    Gltf gltf = one_triangle();
    gltf.primitive(0)["attributes"]["TEXCOORD_0"] =
        gltf.add_shorts({0, 65535, 65535, 0, 0, 0}, 2, true);
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->meshes[0]->texture_coordinates[0], (std::vector<V2f>{{0, 1}, {1, 0}, {0, 0}}));
}

TEST_F(GltfGeometry, StrideAndOffsetAreFollowed) {
    // Positions and normals interleaved in one view, after four bytes of something else.
    Gltf gltf;
    gltf.buffer = std::string(4, 'x');
    std::vector<float> vertices{0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1};
    gltf.buffer.append(reinterpret_cast<const char*>(vertices.data()), vertices.size() * 4);
    gltf.json["bufferViews"] = {
        {{"buffer", 0}, {"byteOffset", 4}, {"byteLength", 72}, {"byteStride", 24}}};
    for (const int offset : {0, 12}) {
        gltf.json["accessors"].push_back({{"bufferView", 0},
                                          {"byteOffset", offset},
                                          {"count", 3},
                                          {"componentType", 5126},
                                          {"type", "VEC3"}});
    }
    gltf.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}}}}}};
    gltf.add_node({{"mesh", 0}});
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->meshes[0]->positions, (std::vector<V3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(scene->meshes[0]->normals[2], V3f(0, 0, 1));
}

TEST_F(GltfGeometry, SparseAccessorsReplaceElements) {
    Gltf gltf = one_triangle();
    const std::size_t place = gltf.add_shorts({1}, 1);
    const std::size_t value = gltf.add_floats({8, 0, 0}, 3);
    const std::size_t positions = gltf.primitive(0)["attributes"]["POSITION"];
    gltf.json["accessors"][positions]["sparse"] = {
        {"count", 1},
        {"indices",
         {{"bufferView", gltf.json["accessors"][place]["bufferView"]}, {"componentType", 5123}}},
        {"values", {{"bufferView", gltf.json["accessors"][value]["bufferView"]}}}};
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->bounds().max, V3f(8, 1, 0));
}

TEST_F(GltfGeometry, NodesOutsideTheSceneAreNotShown) {
    Gltf gltf = one_triangle();
    gltf.add_node({{"mesh", 0}}, false);
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->objects.size(), 1U);
}

TEST_F(GltfGeometry, DeepTreesDoNotOverflowTheStack) {
    Gltf gltf;
    const std::size_t mesh = gltf.add_triangle("mesh");
    constexpr std::size_t depth = 50000;
    for (std::size_t i = 0; i < depth; ++i) {
        gltf.add_node({{"children", {i + 1}}, {"translation", {1, 0, 0}}}, i == 0);
    }
    gltf.add_node({{"mesh", mesh}}, false);
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    expect_near(V3d(0.0) * scene->instances[0].world_from_mesh, V3d(depth, 0, 0));
}

TEST_F(GltfGeometry, FormatIsStated) {
    const Gltf gltf = one_triangle();
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->format, "glTF 2.0 binary");
    EXPECT_EQ(scene->axes, Axes::y_up);
    EXPECT_EQ(scene->meters_per_unit, 1.0);
    EXPECT_EQ(scene->name, (folder / "scene.glb").string());

    Json json = gltf.json;
    json["buffers"] = {{{"uri", "the%20data.bin"}, {"byteLength", gltf.buffer.size()}}};
    write("the data.bin", gltf.buffer);
    const auto text_form = load(write("scene.gltf", json.dump()));
    ASSERT_TRUE(text_form) << said(text_form);
    EXPECT_EQ(text_form->format, "glTF 2.0");
    EXPECT_EQ(text_form->meshes[0]->positions, scene->meshes[0]->positions);
}

TEST_F(GltfGeometry, BuffersMayBeDataUris) {
    // Three positions: zeros but for 1.0F = 00 00 80 3f.
    Json json = one_triangle().json;
    json["accessors"] = {
        {{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}}};
    json["bufferViews"] = {{{"buffer", 0}, {"byteLength", 36}}};
    json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}};
    json["buffers"] = {{{"byteLength", 36},
                        {"uri",
                         "data:application/octet-stream;base64,"
                         "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}};
    const auto scene = load(write("scene.gltf", json.dump()));
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->meshes[0]->positions, (std::vector<V3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

// Long ones are not parsed as JSON.
TEST_F(GltfGeometry, LongDataUris) {
    const auto base64 = [](const std::vector<std::uint8_t>& bytes) {
        constexpr std::string_view digits =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string text;
        for (std::size_t i = 0; i < bytes.size(); i += 3) {
            std::uint32_t bits = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                bits = bits << 8U | (i + k < bytes.size() ? bytes[i + k] : 0U);
            }
            for (const unsigned shift : {18U, 12U, 6U, 0U}) {
                text += digits[bits >> shift & 63U];
            }
        }
        const std::size_t missing = (3 - bytes.size() % 3) % 3;
        return text.replace(text.size() - missing, missing, missing, '=');
    };
    // Of every length modulo 3.
    for (const std::size_t vertices : {600U, 601U, 602U}) {
        std::vector<V3f> points;
        for (std::size_t i = 0; i < vertices; ++i) {
            const auto x = static_cast<float>(i);
            points.emplace_back(x, x * x, -x);
        }
        std::vector<std::uint8_t> bytes(12 * vertices + vertices % 3);
        std::memcpy(bytes.data(), points.data(), 12 * vertices);
        Json json = one_triangle().json;
        json["accessors"] = {{{"bufferView", 0},
                              {"componentType", 5126},
                              {"count", vertices / 3 * 3},
                              {"type", "VEC3"}}};
        json["bufferViews"] = {{{"buffer", 0}, {"byteLength", 12 * vertices}}};
        json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}};
        const std::string uri = "data:application/octet-stream;base64," + base64(bytes);
        json["buffers"] = {{{"byteLength", bytes.size()}, {"uri", uri}}};
        json["nodes"][0]["name"] = R"(a quoted "data: text)";
        const auto whole = load(write("scene.gltf", json.dump()));
        ASSERT_TRUE(whole) << said(whole);
        points.resize(vertices / 3 * 3);
        EXPECT_EQ(whole->meshes[0]->positions.size(), points.size());
        EXPECT_EQ(whole->meshes[0]->positions.back(), points.back());
        EXPECT_EQ(whole->objects[0].name, R"(a quoted "data: text)");
        for (const char wrong : {'!', '\\', '-', '\0', '\xff'}) {
            std::string text = json.dump();
            text[text.find(";base64,") + 5000] = wrong;
            EXPECT_FALSE(load(write("scene.gltf", text))) << wrong;
        }
        // JSON may escape slashes.
        std::string escaped = json.dump();
        const std::size_t slash = escaped.find('/', escaped.find("data:application"));
        escaped.insert(slash, 1, '\\');
        EXPECT_TRUE(load(write("scene.gltf", escaped)));
        // A mistake behind it is shown where it is in the file.
        const std::string broken = json.dump() + "]";
        EXPECT_NE(said(load(write("scene.gltf", broken))).find(std::to_string(broken.size())),
                  std::string::npos);
    }
}

}  // namespace balcony::scene::testing::gltf_geometry_test
