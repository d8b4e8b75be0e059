// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include "scene_files.hpp"

namespace balcony::scene::testing::glass_test {

namespace {

class Glass : public SceneFiles {
protected:
    // A smooth, closed tetrahedron named "ball", or without its last face a bowl, and an open
    // triangle, all of the same glass.
    [[nodiscard]] static Gltf with_glass(const Json& generator, bool is_closed = true) {
        Gltf gltf = one_triangle();
        gltf.json["asset"]["generator"] = generator;
        gltf.json["materials"] = {
            {{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}}}}};
        gltf.primitive(0)["material"] = 0;
        const std::vector<float> corners{1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1};
        std::vector<float> normals;
        for (const float part : corners) {
            normals.push_back(part / std::sqrt(3.0F));
        }
        std::vector<std::uint16_t> faces{0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};
        faces.resize(is_closed ? 12 : 9);
        const Json attributes{{"POSITION", gltf.add_floats(corners, 3)},
                              {"NORMAL", gltf.add_floats(normals, 3)}};
        gltf.json["meshes"].push_back({{"primitives",
                                        {{{"attributes", attributes},
                                          {"indices", gltf.add_shorts(faces, 1)},
                                          {"material", 0}}}}});
        gltf.add_node({{"name", "ball"}, {"mesh", 1}});
        return gltf;
    }

    [[nodiscard]] Result<Scene> load_as(const Gltf& gltf, std::optional<bool> solid) const {
        return load(write("glass.glb", gltf.glb()), {}, {}, {.solid_glass = solid});
    }

    static bool is_thin(const Scene& scene, std::size_t mesh) {
        return scene.materials[scene.meshes[mesh]->material.value()].thin_walled;
    }
};

constexpr std::string_view blender = "Khronos glTF Blender I/O v3.4.50";
constexpr std::string_view warning = "the glass of 'ball' has no volume";

}  // namespace

TEST_F(Glass, OfBlenderIsThinAndNamed) {
    const auto scene = load_as(with_glass(blender), {});
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(says(scene, warning)) << said(scene);
    EXPECT_TRUE(is_thin(*scene, 0));
    EXPECT_TRUE(is_thin(*scene, 1));
}

TEST_F(Glass, IsNotNamedWhereItIsMeant) {
    EXPECT_FALSE(says(load_as(with_glass("Balcony"), {}), warning));
    EXPECT_FALSE(says(load_as(with_glass(blender), false), warning));
    EXPECT_FALSE(says(load_as(with_glass(blender, false), {}), warning));
    Gltf faceted = with_glass(blender);
    faceted.primitive(1)["attributes"].erase("NORMAL");
    EXPECT_FALSE(says(load_as(faceted, {}), warning));
    Gltf volume = with_glass(blender);
    volume.json["materials"][0]["extensions"]["KHR_materials_volume"]["thicknessFactor"] = 1;
    EXPECT_FALSE(says(load_as(volume, {}), warning));
}

TEST_F(Glass, OfClosedObjectsBecomesSolid) {
    const auto scene = load_as(with_glass("Balcony"), true);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_FALSE(says(scene, warning));
    EXPECT_TRUE(is_thin(*scene, 0)) << "the triangle is open";
    EXPECT_FALSE(is_thin(*scene, 1));
    const auto bowl = load_as(with_glass("Balcony", false), true);
    ASSERT_TRUE(bowl) << said(bowl);
    EXPECT_TRUE(is_thin(*bowl, 1));
}

}  // namespace balcony::scene::testing::glass_test
