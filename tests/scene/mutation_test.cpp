// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Scene files with random byte changes: load() returns for any content. The seed is fixed,
// so that a failure can be repeated; the numbers are small enough for every test run.

#include <cstdint>
#include <random>

#include "scene_files.hpp"

namespace balcony::scene::testing {

namespace {

using Mutations = SceneFiles;

constexpr int files_tried = 400;

std::string mutate(std::string bytes, std::mt19937& random) {
    const std::string_view structure = " -/,:[]{}\"\n.e0123456789";
    const auto changes = 1 + random() % 6;
    for (std::uint32_t i = 0; i < changes; ++i) {
        char& byte = bytes[random() % bytes.size()];
        const bool is_digit = byte >= '0' && byte <= '9';
        byte = is_digit            ? static_cast<char>('0' + random() % 10)
               : random() % 2 == 0 ? structure[random() % structure.size()]
                                   : static_cast<char>(random() % 256);
    }
    return bytes;
}

}  // namespace

TEST_F(Mutations, OfGlbNeverCrash) {
    Gltf gltf = one_triangle();
    gltf.primitive(0)["attributes"]["TEXCOORD_0"] = gltf.add_shorts({0, 1, 2, 3, 4, 5}, 2, true);
    gltf.primitive(0)["material"] = 0;
    gltf.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    gltf.json["images"] = {{{"uri", "data:image/png;base64,QUJD"}}};
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.add_node(
        {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1}}, {"children", {2}}});
    gltf.add_node({{"mesh", 0}, {"rotation", {0, 0, 0, 1}}}, false);
    const std::string whole = gltf.glb();
    ASSERT_TRUE(load(write("scene.glb", whole)));
    std::mt19937 random(7);
    for (int i = 0; i < files_tried; ++i) {
        const auto result = load(write("scene.glb", mutate(whole, random)));
        ASSERT_TRUE(result || has_errors(result.diagnostics));
    }
}

TEST_F(Mutations, OfObjNeverCrash) {
    write("a.mtl", "newmtl red\nKd 1 0 0\nmap_Kd -clamp on t.png\n");
    const std::string whole =
        "mtllib a.mtl\no one\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
        "vn 0 0 1\nusemtl red\nf 1/1/1 2/2/1 3/3/1\nf -3//1 -1//1 -2//1\ng two\nusemtl b\n"
        "f 1 2 3 4\nl 1 2\n";
    ASSERT_TRUE(load(write("scene.obj", whole)));
    std::mt19937 random(7);
    for (int i = 0; i < files_tried; ++i) {
        const auto result = load(write("scene.obj", mutate(whole, random)));
        ASSERT_TRUE(result || has_errors(result.diagnostics));
    }
}

}  // namespace balcony::scene::testing
