// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Geometry in the same place is limited, since every ray meets all of it.

#include "scene/coincident.hpp"

#include <string>

#include "scene_files.hpp"

namespace balcony::scene::testing::coincident_test {

namespace {

using Coincident = SceneFiles;

// A triangle, and many others in one place, with their corners in different order.
std::string stack(std::size_t count) {
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -0 0 5\nf 1 2 4\n";
    for (std::size_t i = 0; i < count; ++i) {
        text += i % 2 == 0 ? "f 1 2 3\n" : "f 3 2 1\n";
    }
    return text;
}

}  // namespace

TEST_F(Coincident, TrianglesAreLimited) {
    const auto few = load_obj(stack(max_coincident));
    ASSERT_TRUE(few && few.diagnostics.empty()) << said(few);
    EXPECT_EQ(few->triangle_count(), 1 + max_coincident);
    const auto many = load_obj(stack(100'000));
    ASSERT_TRUE(many) << said(many);
    EXPECT_EQ(many->triangle_count(), 1 + max_coincident);
    EXPECT_TRUE(says(many, "99984 triangles skipped, each in the same place as 16 others"));
}

// However many there are in all, and whatever their hashes.
TEST_F(Coincident, TrianglesElsewhereStay) {
    std::string text;
    constexpr int side = 200;
    for (int i = 0; i < side * side; ++i) {
        const int x = i % side;
        const int y = i / side;
        text += "v " + std::to_string(x) + ' ' + std::to_string(y) + " 0\n";
    }
    std::size_t count = 0;
    for (int i = side; i < side * side; ++i) {
        if (i % side != 0) {
            text += "f " + std::to_string(i + 1) + ' ' + std::to_string(i) + ' ' +
                    std::to_string(i - side + 1) + '\n';
            ++count;
        }
    }
    const auto scene = load_obj(text);
    ASSERT_TRUE(scene && scene.diagnostics.empty()) << said(scene);
    EXPECT_EQ(scene->triangle_count(), count);
}

TEST_F(Coincident, InstancesAreLimitedUnlessTheyMove) {
    Gltf gltf = one_triangle();
    for (std::size_t i = 0; i < 1000; ++i) {
        gltf.add_node({{"name", "copy"}, {"mesh", i % 2 == 0 ? 0 : gltf.add_triangle("another")}});
    }
    const std::size_t moving = gltf.add_node({{"name", "moving"}, {"mesh", 0}});
    const std::size_t times = gltf.add_floats({0, 1}, 1);
    const std::size_t places = gltf.add_floats({0, 0, 0, 7, 0, 0}, 3);
    gltf.json["animations"] = {
        {{"channels", {{{"sampler", 0}, {"target", {{"node", moving}, {"path", "translation"}}}}}},
         {"samplers", {{{"input", times}, {"output", places}}}}}};
    gltf.add_node({{"name", "elsewhere"}, {"mesh", 0}, {"translation", {0, 0, 1}}});
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(says(scene, "985 instances skipped, each in the same place as 16 others"));
    ASSERT_EQ(scene->instances.size(), max_coincident + 2);
    EXPECT_EQ(scene->objects.size(), 1003U);
    EXPECT_EQ(scene->objects[scene->instances[max_coincident - 1].object].name, "copy");
    EXPECT_EQ(scene->objects[scene->instances[max_coincident].object].name, "moving");
    EXPECT_EQ(scene->objects[scene->instances[max_coincident + 1].object].name, "elsewhere");
    ASSERT_EQ(scene->motion->instances.size(), 1U);
    EXPECT_EQ(scene->motion->instances[0].instance, max_coincident);
}

}  // namespace balcony::scene::testing::coincident_test
