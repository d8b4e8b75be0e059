// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Scene files with bytes changed at random: whatever they hold, load() returns a scene that keeps
// its promises, or an error. The seed is fixed, so that a failure can be repeated; the numbers are
// small enough for every test run.

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <random>

#include "../laws/scene_laws.hpp"
#include "scene_files.hpp"

namespace balcony::scene::testing::mutation_test {

namespace {

using Mutations = SceneFiles;

constexpr int files_tried = 400;

// A number becomes one at the end of some range, or beyond.
void change_number(std::string& bytes, std::mt19937& random) {
    static constexpr std::string_view numbers[] = {"0",     "-1",       "1e-300", "1e-18", "1e9",
                                                   "1e12",  "1e18",     "1e30",   "1e39",  "1e308",
                                                   "65536", "99999999", "null"};
    const std::size_t begin = bytes.find_first_of("0123456789", random() % bytes.size());
    if (begin != std::string::npos) {
        const std::size_t end =
            std::min(bytes.find_first_not_of("0123456789.e-", begin), bytes.size());
        bytes.replace(begin, end - begin, numbers[random() % std::size(numbers)]);
    }
}

Result<Scene> load_bytes(const std::filesystem::path& name, const std::string& bytes) {
    return load(name, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

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

// A bit of whatever is read.
Gltf everything() {
    Gltf gltf = one_triangle();
    gltf.primitive(0)["attributes"]["TEXCOORD_0"] = gltf.add_shorts({0, 1, 2, 3, 4, 5}, 2, true);
    gltf.primitive(0)["material"] = 0;
    gltf.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    gltf.json["images"] = {{{"uri", "data:image/png;base64,QUJD"}}};
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.add_node(
        {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1}}, {"children", {2}}});
    gltf.add_node({{"mesh", 0}, {"rotation", {0, 0, 0, 1}}, {"scale", {1, 2, 3}}}, false);
    gltf.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"}, {"intensity", 40}, {"range", 7}, {"color", {1, 0.5, 0.25}}}};
    gltf.add_node(
        {{"translation", {1, 2, 3}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    return gltf;
}

}  // namespace

TEST_F(Mutations, OfGlbNeverCrash) {
    const std::string whole = everything().glb();
    ASSERT_TRUE(load(write("scene.glb", whole)));
    std::mt19937 random(7);
    int loaded = 0;
    for (int i = 0; i < files_tried; ++i) {
        const auto result = load_bytes("scene.glb", mutate(whole, random));
        ASSERT_EQ(laws::broken_law(result), "") << i;
        loaded += result ? 1 : 0;
    }
    EXPECT_GT(loaded, files_tried / 20) << "the changes leave too little to try";
}

// The text form, whose numbers may change their length.
TEST_F(Mutations, OfNumbersNeverCrash) {
    Gltf gltf = everything();
    Json complete = gltf.json;
    write("data.bin", gltf.buffer);
    complete["buffers"] = {{{"uri", "data.bin"}, {"byteLength", gltf.buffer.size()}}};
    const std::string whole = complete.dump();
    const std::filesystem::path name = folder / "scene.gltf";
    ASSERT_TRUE(load_bytes(name, whole)) << said(load_bytes(name, whole));
    std::mt19937 random(7);
    int loaded = 0;
    for (int i = 0; i < files_tried; ++i) {
        std::string text = whole;
        for (auto changes = 1 + random() % 3; changes > 0; --changes) {
            change_number(text, random);
        }
        const auto result = load_bytes(name, text);
        ASSERT_EQ(laws::broken_law(result), "") << text;
        loaded += result ? 1 : 0;
    }
    EXPECT_GT(loaded, files_tried / 20) << "the changes leave too little to try";
}

// Loads mutations of a file; enough of them must remain scenes. Half of them spare its header.
class MeshMutations : public SceneFiles {
protected:
    void try_mutations(const std::string& name, const std::string& whole,
                       std::size_t header = 0) const {
        ASSERT_TRUE(load(write(name, whole)));
        std::mt19937 random(7);
        int loaded = 0;
        for (int i = 0; i < files_tried; ++i) {
            const std::size_t spared = i % 2 == 0 ? header : 0;
            const auto result = load_bytes(
                folder / name, whole.substr(0, spared) + mutate(whole.substr(spared), random));
            ASSERT_EQ(laws::broken_law(result), "") << i;
            loaded += result ? 1 : 0;
        }
        EXPECT_GT(loaded, files_tried / 20) << "the changes leave too little to try";
    }
};

TEST_F(MeshMutations, OfStlNeverCrash) {
    std::string binary(84, ' ');
    binary[80] = 2;
    binary[81] = binary[82] = binary[83] = 0;
    for (const float number : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F}) {
        binary.append(reinterpret_cast<const char*>(&number), sizeof(number));
    }
    binary.insert(84, 12, '\0').append(2, '\0').append(binary.substr(84, 50));
    try_mutations("scene.stl", binary);
    try_mutations("scene.stl",
                  "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                  "vertex 0 1 0\nendloop\nendfacet\nendsolid\n");
}

TEST_F(MeshMutations, OfPlyNeverCrash) {
    const std::string header =
        "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        "element face 2\nproperty list uchar uchar vertex_indices\nend_header\n";
    const std::string text = "ply\nformat ascii 1.0\n" + header;
    try_mutations("scene.ply",
                  text +
                      "0 0 0 1 2 3\n1 0 0 4 5 6\n0 1 0 7 8 9\n1 1 0 9 9 9\n"
                      "3 0 1 2\n4 0 1 3 2\n",
                  text.size());
    std::string binary = "ply\nformat binary_little_endian 1.0\n" + header;
    const std::size_t body = binary.size();
    for (int i = 0; i < 4; ++i) {
        const float xyz[] = {static_cast<float>(i % 2), static_cast<float>(i / 2), 0.0F};
        binary.append(reinterpret_cast<const char*>(xyz), sizeof(xyz)).append("abc");
    }
    binary.append({3, 0, 1, 2, 4, 0, 1, 3, 2});
    try_mutations("scene.ply", binary, body);
}

TEST_F(MeshMutations, OfObjNeverCrash) {
    write("a.mtl", "newmtl red\nKd 1 0 0\nmap_Kd -clamp on t.png\n");
    const std::string whole =
        "mtllib a.mtl\no one\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
        "vn 0 0 1\nusemtl red\nf 1/1/1 2/2/1 3/3/1\nf -3//1 -1//1 -2//1\ng two\nusemtl b\n"
        "s 1\nf 1 2 3 4\ns off\nf 2 4 3 1\nl 1 2\nv 2 0 0 1 0.5 0\n";
    try_mutations("scene.obj", whole);
}

}  // namespace balcony::scene::testing::mutation_test
