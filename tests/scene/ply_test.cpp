// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <bit>

#include "scene_files.hpp"

namespace balcony::scene::testing::ply_test {

namespace {

using Ply = SceneFiles;

const std::string vertex_header =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string face_header = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string corners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string text_file(const std::string& header, const std::string& body) {
    return "ply\nformat ascii 1.0\ncomment by hand\n" + header + "end_header\n" + body;
}

// The bytes of a number, in the order of the file.
template <class Number>
std::string bytes_of(Number number, bool big_endian) {
    std::string bytes(reinterpret_cast<const char*>(&number), sizeof(number));
    if (big_endian == (std::endian::native == std::endian::little)) {
        std::reverse(bytes.begin(), bytes.end());
    }
    return bytes;
}

}  // namespace

TEST_F(Ply, AnElementIsStatedOnce) {
    const std::string with_normals =
        "element vertex 1\nproperty float x\nproperty float y\n"
        "property float z\nproperty float nx\nproperty float ny\n"
        "property float nz\n";
    const auto scene = load(write("twice.ply", text_file(vertex_header + with_normals + face_header,
                                                         corners + "0 0 0 0 0 1\n4 0 1 2 3\n")));
    EXPECT_FALSE(scene);
    EXPECT_NE(said(scene).find("element vertex 1"), std::string::npos) << said(scene);
}

TEST_F(Ply, TextIsRead) {
    const auto scene =
        load(write("square.ply", text_file(vertex_header + face_header, corners + "4 0 1 2 3\n")));
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(scene.diagnostics.empty()) << said(scene);
    EXPECT_EQ(scene->format, "PLY");
    EXPECT_EQ(scene->axes, Axes::z_up);
    EXPECT_EQ(scene->objects[0].name, "square");
    EXPECT_EQ(scene->triangle_count(), 2U);
    EXPECT_EQ(scene->bounds().max, V3f(1, 1, 0));
    EXPECT_EQ(scene->meshes[0]->positions.size(), 4U);
    EXPECT_EQ(scene->meshes[0]->normals[0], V3f(0, 0, 1));
    EXPECT_TRUE(scene->meshes[0]->colors.empty());
}

// Properties of several types in any order, some of them unknown, and an unknown element.
TEST_F(Ply, BinaryIsReadInBothByteOrders) {
    for (const bool big_endian : {false, true}) {
        std::string file = "ply\nformat binary_" + std::string(big_endian ? "big" : "little") +
                           "_endian 1.0\nelement camera 1\nproperty list ushort double pose\n"
                           "element vertex 3\nproperty uchar red\nproperty uchar green\n"
                           "property uchar blue\nproperty short quality\nproperty double x\n"
                           "property double y\nproperty double z\nproperty float nx\n"
                           "property float ny\nproperty float nz\nproperty float s\n"
                           "property float t\nelement face 1\nproperty char flags\n"
                           "property list uint ushort vertex_index\nend_header\n";
        const auto add = [&](auto number) { file += bytes_of(number, big_endian); };
        add(std::uint16_t{2});
        add(1.0);
        add(2.0);
        for (int i = 0; i < 3; ++i) {
            add(static_cast<std::uint8_t>(255));
            add(static_cast<std::uint8_t>(128));
            add(static_cast<std::uint8_t>(0));
            add(std::int16_t{-5});
            add(i == 1 ? 2.5 : 0.0);
            add(i == 2 ? 1.5 : 0.0);
            add(-1.0);
            add(0.0F);
            add(0.6F);
            add(0.8F);
            add(0.25F);
            add(0.25F);
        }
        add(std::int8_t{7});
        add(std::uint32_t{3});
        for (std::uint16_t index = 0; index < 3; ++index) {
            add(index);
        }
        const auto scene = load(write("a.ply", file));
        ASSERT_TRUE(scene) << said(scene);
        EXPECT_TRUE(scene.diagnostics.empty()) << said(scene);
        const Mesh& mesh = scene->meshes[0];
        EXPECT_EQ(scene->bounds().max, V3f(2.5F, 1.5F, -1.0F));
        EXPECT_NEAR((mesh.normals[0] - V3f(0.0F, 0.6F, 0.8F)).length(), 0.0F, 1e-6F);
        EXPECT_EQ(mesh.texture_coordinates[0][0], V2f(0.25F, 0.75F));
        // 128 / 255 in sRGB.
        EXPECT_NEAR(mesh.colors[0].r, 1.0F, 1e-6F);
        EXPECT_NEAR(mesh.colors[0].g, 0.21586050F, 1e-6F);
        EXPECT_EQ(mesh.colors[0].b, 0.0F);
    }
}

TEST_F(Ply, StripsAreSeparatedAndTurned) {
    const auto scene = load(write(
        "a.ply",
        text_file(vertex_header + "element tristrips 1\nproperty list int int vertex_indices\n",
                  "0 0 0\n1 0 0\n0 1 0\n1 1 0\n8 0 1 2 3 -1 0 1 2\n")));
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->triangle_count(), 3U);
    for (const V3f& normal : scene->meshes[0]->normals) {
        EXPECT_EQ(normal, V3f(0, 0, 1));
    }
}

TEST_F(Ply, BrokenFilesKeepWhatCanBeUsed) {
    const std::string two_faces = "element face 2\nproperty list uchar int vertex_indices\n";
    const auto cut =
        load(write("a.ply", text_file(vertex_header + two_faces, corners + "3 0 1 2\n3 0 1")));
    ASSERT_TRUE(cut) << said(cut);
    EXPECT_EQ(cut->triangle_count(), 1U);
    EXPECT_TRUE(says(cut, "the file ends before the last 'face' of 2"));
    const auto wrong =
        load(write("a.ply", text_file(vertex_header + two_faces, corners + "3 0 1 2\n3 0 1 -4\n")));
    ASSERT_TRUE(wrong) << said(wrong);
    EXPECT_TRUE(says(wrong, "1 face skipped because of a vertex index out of range"));
    const auto points = load(write("a.ply", text_file(vertex_header, corners)));
    EXPECT_FALSE(points);
    EXPECT_TRUE(says(points, "it has no triangles"));
}

TEST_F(Ply, AHeaderThatIsNotUnderstoodIsAnError) {
    const auto message = [&](const std::string& bytes) {
        const auto result = load(write("a.ply", bytes));
        EXPECT_FALSE(result);
        return said(result);
    };
    const auto has = [](const std::string& text, const char* part) {
        return text.find(part) != std::string::npos;
    };
    EXPECT_TRUE(has(message("solid"), "does not begin with 'ply'"));
    EXPECT_TRUE(has(message("ply\nformat ascii 1.0\n"), "'end_header' is missing"));
    EXPECT_TRUE(has(message("ply\nformat binary 1.0\nend_header\n"), "line 2 of '"));
    EXPECT_TRUE(has(message("ply\nproperty float x\nend_header\n"), "line 2 of '"));
    EXPECT_TRUE(has(message("ply\nelement vertex -3\nend_header\n"), "line 2 of '"));
    EXPECT_TRUE(has(message("ply\nelement vertex 1\nproperty real x\nend_header\n"), "line 3 of"));
    EXPECT_TRUE(has(message(text_file("element vertex 1\nproperty float x\n", "0\n")),
                    "have no x, y and z"));
    // Counts that no file has.
    EXPECT_TRUE(has(message(text_file("element vertex 18446744073709551615\nproperty float x\n"
                                      "property float y\nproperty float z\n",
                                      "0 0 0\n")),
                    "no triangles"));
}

}  // namespace balcony::scene::testing::ply_test
