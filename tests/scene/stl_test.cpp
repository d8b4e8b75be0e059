// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cstring>

#include "scene_files.hpp"

namespace balcony::scene::testing::stl_test {

namespace {

using Stl = SceneFiles;
using Triangle = std::array<V3f, 3>;

const std::vector<Triangle> fold{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                 {{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}}};

std::string binary(const std::vector<Triangle>& triangles, std::string header = "made by hand") {
    header.resize(80);
    const auto count = static_cast<std::uint32_t>(triangles.size());
    header.append(reinterpret_cast<const char*>(&count), sizeof(count));
    for (const Triangle& triangle : triangles) {
        header.append(12, '\0');
        header.append(reinterpret_cast<const char*>(triangle.data()), sizeof(triangle));
        header.append(2, '\0');
    }
    return header;
}

}  // namespace

TEST_F(Stl, BinaryTrianglesAreJoined) {
    const auto scene = load(write("part.stl", binary(fold)));
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(scene.diagnostics.empty()) << said(scene);
    EXPECT_EQ(scene->format, "STL");
    EXPECT_EQ(scene->axes, Axes::z_up);
    EXPECT_EQ(scene->objects[0].name, "part");
    EXPECT_EQ(scene->triangle_count(), 2U);
    EXPECT_EQ(scene->bounds().max, V3f(1.0F));
}

// The file has no indices: corners at the same place belong together.
TEST_F(Stl, EqualCornersAreSmoothUpToAnAngle) {
    const std::vector<Triangle> gentle{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                       {{{1, 0, 0}, {1, 1, -0.3F}, {0, 1, 0}}}};
    const auto edge_normals = [&](const std::vector<Triangle>& triangles) {
        const auto scene = load(write("part.stl", binary(triangles)));
        EXPECT_TRUE(scene) << said(scene);
        const Mesh& mesh = scene->meshes[0];
        std::vector<V3f> found;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            if (mesh.positions[i] == V3f(1, 0, 0)) {
                found.push_back(mesh.normals[i]);
            }
        }
        return found;
    };
    const auto smooth = edge_normals(gentle);
    ASSERT_EQ(smooth.size(), 2U);
    EXPECT_EQ(smooth[0], smooth[1]);
    const auto sharp = edge_normals(fold);
    ASSERT_EQ(sharp.size(), 2U);
    EXPECT_EQ(sharp[0], V3f(0, 0, 1));
    EXPECT_EQ(sharp[1], V3f(0, 1, 0));
}

TEST_F(Stl, SolidsOfATextAreObjects) {
    const std::string facet =
        "FACET NORMAL 0 0 1\n OUTER LOOP\n vertex 0 0 0\n vertex 1 0 0\n vertex 0 1e0 0\n"
        " ENDLOOP\nENDFACET\n";
    const auto scene = load(write("a.stl", "solid left wall\n" + facet + "endsolid\nsolid right\n" +
                                               facet + "endsolid right\n"));
    ASSERT_TRUE(scene) << said(scene);
    ASSERT_EQ(scene->objects.size(), 2U);
    EXPECT_EQ(scene->objects[0].name, "left wall");
    EXPECT_EQ(scene->objects[1].name, "right");
    EXPECT_TRUE(scene.diagnostics.empty()) << said(scene);
}

TEST_F(Stl, ABinaryHeaderMayBeginLikeAText) {
    const auto scene = load(write("a.stl", binary(fold, "solid of a careless program")));
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->triangle_count(), 2U);
}

TEST_F(Stl, BrokenFilesKeepWhatCanBeUsed) {
    const std::string whole = binary(fold);
    const auto cut = load(write("cut.stl", whole.substr(0, whole.size() - 10)));
    ASSERT_TRUE(cut) << said(cut);
    EXPECT_EQ(cut->triangle_count(), 1U);
    EXPECT_TRUE(says(cut, "the file ends after 1 of its 2 triangles"));
    const auto text = load(write("a.stl",
                                 "solid\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\n"
                                 "vertex 0 0 0\nvertex 1 0 0\nendfacet\n"
                                 "vertex nan 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\n"));
    ASSERT_TRUE(text) << said(text);
    EXPECT_EQ(text->triangle_count(), 1U);
    EXPECT_TRUE(says(text, "1 facet skipped without exactly 3 corners"));
    EXPECT_TRUE(says(text, "1 face skipped because of a vertex that is not finite"));
    EXPECT_FALSE(load(write("a.stl", "")));
    EXPECT_FALSE(load(write("a.stl", std::string(84, '\xff'))));
}

}  // namespace balcony::scene::testing::stl_test
