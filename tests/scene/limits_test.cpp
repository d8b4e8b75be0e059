// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What a scene file may ask for is limited by its own size, and numbers by their range.

#include "scene/coincident.hpp"
#include "scene_files.hpp"

namespace balcony::scene::testing::limits_test {

namespace {

using Limits = SceneFiles;

// A row of `count` triangles.
Gltf triangle_row(std::size_t count) {
    Gltf gltf;
    std::vector<float> positions;
    for (std::size_t i = 0; i < 3 * count; ++i) {
        positions.insert(positions.end(),
                         {static_cast<float>(i), static_cast<float>(i % 3 * (i % 3)), 0.0F});
    }
    const std::size_t accessor = gltf.add_floats(positions, 3);
    gltf.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", accessor}}}}}}}};
    gltf.add_node({{"name", "row"}, {"mesh", 0}});
    return gltf;
}

// A node of the one triangle beside the node of one_triangle().
Gltf with_node(Json node) {
    Gltf gltf = one_triangle();
    node["name"] = "second";
    node["mesh"] = 0;
    gltf.add_node(node);
    return gltf;
}

Gltf with_light(Json light, Json node) {
    Gltf gltf = one_triangle();
    light.emplace("type", "point");
    gltf.json["extensions"]["KHR_lights_punctual"]["lights"] = {light};
    node["name"] = "lamp";
    node["extensions"]["KHR_lights_punctual"]["light"] = 0;
    gltf.add_node(node);
    return gltf;
}

}  // namespace

TEST_F(Limits, ElementsWithoutBytesAreAsManyAsTheFileHasBytes) {
    Gltf gltf = one_triangle();
    gltf.json["accessors"][0].erase("bufferView");
    gltf.json["accessors"][0]["count"] = 100'000;
    gltf.primitive(0)["attributes"].erase("NORMAL");
    gltf.primitive(0).erase("indices");
    EXPECT_TRUE(says(load_glb(gltf), "an accessor without a buffer view has more elements than"));
    gltf.json["accessors"][0]["count"] = 300;
    const auto zeros = load_glb(gltf);
    EXPECT_FALSE(says(zeros, "an accessor without a buffer view")) << said(zeros);
}

// A thousand primitives of the same 30,000 corners would be 30 million corners of a megabyte.
TEST_F(Limits, CornersAreLimitedByTheSizeOfTheFile) {
    Gltf gltf = triangle_row(10'000);
    Json& primitives = gltf.json["meshes"][0]["primitives"];
    const Json primitive = primitives[0];
    for (int i = 0; i < 1000; ++i) {
        primitives.push_back(primitive);
    }
    const std::size_t file_size = gltf.glb().size();
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(says(scene, "the file's meshes have more corners than a file of its size may"));
    std::size_t corners = 0;
    for (const Mesh& mesh : scene->meshes) {
        corners += 3 * mesh.triangles.size();
    }
    EXPECT_LE(corners, file_size + (1U << 22U));
    EXPECT_GT(corners, 1U << 22U);
}

TEST_F(Limits, SharedVerticesAreNotCopied) {
    // Each primitive has one triangle of many vertices.
    Gltf gltf = triangle_row(1000);
    Json& primitives = gltf.json["meshes"][0]["primitives"];
    const std::size_t positions = primitives[0]["attributes"]["POSITION"];
    primitives = Json::array();
    for (std::uint16_t i = 0; i < 50; ++i) {
        const auto first = static_cast<std::uint16_t>(3 * i);
        const std::vector<std::uint16_t> corners{first, static_cast<std::uint16_t>(first + 1),
                                                 static_cast<std::uint16_t>(first + 2)};
        primitives.push_back(
            {{"attributes", {{"POSITION", positions}}}, {"indices", gltf.add_shorts(corners, 1)}});
    }
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    ASSERT_EQ(scene->meshes.size(), 50U);
    for (std::size_t i = 0; i < scene->meshes.size(); ++i) {
        const float first = 3.0F * static_cast<float>(i);
        EXPECT_EQ(scene->meshes[i]->positions,
                  (std::vector<V3f>{{first, 0, 0}, {first + 1, 1, 0}, {first + 2, 4, 0}}));
    }
}

TEST_F(Limits, InstancesAreLimitedByTheSizeOfTheFile) {
    Gltf gltf = one_triangle();
    Json& primitives = gltf.json["meshes"][0]["primitives"];
    const Json primitive = primitives[0];
    for (int i = 1; i < 400; ++i) {
        primitives.push_back(primitive);
    }
    for (int i = 1; i < 400; ++i) {
        gltf.add_node({{"mesh", 0}, {"translation", {i, 0, 0}}});
    }
    ASSERT_LT(gltf.glb().size(), 1U << 16U);
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(says(scene, "the file has more instances than a file of its size may have"));
    EXPECT_EQ(scene->instances.size(), (1U << 16U) / 400U * max_coincident);
}

TEST_F(Limits, ImagesAreLimitedByTheSizeOfTheFile) {
    Gltf gltf = one_triangle();
    const std::size_t accessor = gltf.add_shorts(std::vector<std::uint16_t>(20'000), 1);
    Json& primitives = gltf.json["meshes"][0]["primitives"];
    const Json primitive = primitives[0];
    primitives = Json::array();
    for (std::size_t i = 0; i < 20; ++i) {
        gltf.json["images"].push_back(
            {{"bufferView", gltf.json["accessors"][accessor]["bufferView"]}});
        gltf.json["textures"].push_back({{"source", i}});
        gltf.json["materials"].push_back(
            {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", i}}}}}});
        primitives.push_back(primitive);
        primitives.back()["material"] = i;
    }
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(says(scene, "the file's images have more bytes than a file of its size may have"));
    std::size_t bytes = 0;
    for (const Texture& texture : scene->textures) {
        bytes += texture.bytes->size();
    }
    EXPECT_GE(scene->textures.size(), 2U);
    EXPECT_LE(bytes, 2 * gltf.glb().size());
}

TEST_F(Limits, TexturesThatShowAnImageInOneWayAreOne) {
    Gltf gltf = one_triangle();
    gltf.json["images"] = {{{"uri", "data:image/png;base64,QUJD"}}};
    gltf.json["samplers"] = {{{"wrapS", 10497}}, {{"wrapS", 33071}}};
    gltf.json["textures"] = {
        {{"source", 0}}, {{"source", 0}, {"sampler", 0}}, {{"source", 0}, {"sampler", 1}}};
    gltf.json["materials"] = {
        {{"pbrMetallicRoughness",
          {{"baseColorTexture", {{"index", 0}}}, {"metallicRoughnessTexture", {{"index", 1}}}}},
         {"emissiveTexture", {{"index", 2}}}}};
    gltf.primitive(0)["material"] = 0;
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    const Material& material = scene->materials[0];
    EXPECT_EQ(scene->textures.size(), 2U);
    EXPECT_EQ(material.base_color_texture.index, material.metallic_texture.index);
    EXPECT_NE(material.base_color_texture.index, material.emission_texture.index);
}

TEST_F(Limits, ABufferFileIsReadOnce) {
    const Gltf gltf = one_triangle();
    Json json = gltf.json;
    write("data.bin", gltf.buffer);
    json["buffers"] = Json::array();
    for (int i = 0; i < 3; ++i) {
        json["buffers"].push_back({{"uri", "data.bin"}, {"byteLength", gltf.buffer.size()}});
    }
    json["bufferViews"][1]["buffer"] = 2;
    const auto scene = load(write("scene.gltf", json.dump()));
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->meshes[0]->normals[0], V3f(0, 0, 1));
}

TEST_F(Limits, TransformsBeyondTheRangeAreLeftOut) {
    const Json affine_but_w = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 3, 0, 0};
    const std::pair<Json, const char*> nodes[] = {
        {{{"matrix", affine_but_w}}, "its 'matrix' is not affine"},
        {{{"scale", {1e-18, 1e-18, 1e-18}}}, "its transform scales beyond 1e-09 .. 1e+09"},
        {{{"scale", {1, 1, 1e-300}}}, "its transform scales beyond 1e-09 .. 1e+09"},
        {{{"scale", {1e10, 1, 1}}}, "its transform scales beyond 1e-09 .. 1e+09"},
        {{{"scale", {1e-200, 1e-200, 1e-200}}}, "its transform is singular"},
        {{{"translation", {2e18, 0, 0}}}, "it reaches further than 1e+12 from the origin"},
        {{{"translation", {0, -1e39, 0}}}, "it reaches further than 1e+12 from the origin"},
        {{{"rotation", {1e200, 1e200, 0, 0}}}, "its 'rotation' has length 0"}};
    for (const auto& [node, reason] : nodes) {
        const auto scene = load_glb(with_node(node));
        ASSERT_TRUE(scene) << node;
        EXPECT_TRUE(says(scene, std::string("node 'second' is skipped: ") + reason)) << node;
        EXPECT_EQ(scene->instances.size(), 1U) << node;
    }
    for (const Json& node : {Json{{"scale", {1e9, 1e9, 1e9}}}, Json{{"scale", {1e-9, 1e-9, -1e-9}}},
                             Json{{"translation", {0, 0, 9.9e11}}}}) {
        const auto scene = load_glb(with_node(node));
        ASSERT_TRUE(scene) << said(scene);
        EXPECT_EQ(scene->instances.size(), 2U) << node << said(scene);
    }
}

TEST_F(Limits, RoundedMatricesAreMadeAffine) {
    const auto scene = load_glb(
        with_node({{"matrix", {1, 0, 0, 1e-9, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 0.9999999}}}));
    ASSERT_TRUE(scene) << said(scene);
    ASSERT_EQ(scene->instances.size(), 2U);
    EXPECT_EQ(V3d(1, 1, 1) * scene->instances[1].world_from_mesh, V3d(2, 3, 4));
}

TEST_F(Limits, LightsBeyondTheRangeAreLeftOut) {
    const std::tuple<Json, Json, const char*> lights[] = {
        {Json::object(), {{"translation", {1e308, 1e308, 0}}}, "it is further than 1e+12 from"},
        {{{"intensity", 1e308}}, Json::object(), "its 'intensity' is not in the range 0 .. 1e+30"},
        {{{"intensity", 1e20}, {"color", {1e20, 1, 1}}}, Json::object(), "its 'intensity' is not"},
        {{{"color", {-1, 1, 1}}}, Json::object(), "its 'color' is not in the range"},
        {{{"range", 1e300}}, Json::object(), "its 'range' is not in the range"},
        {Json::object(), {{"scale", {1e250, 1e250, 1e250}}}, "its node's transform gives it"}};
    for (const auto& [light, node, reason] : lights) {
        const auto scene = load_glb(with_light(light, node));
        ASSERT_TRUE(scene) << light;
        EXPECT_TRUE(says(scene, std::string("light 'lamp' is skipped: ") + reason)) << light;
        EXPECT_TRUE(scene->lights.empty()) << light;
    }
}

TEST_F(Limits, MaterialsBeyondTheRangeAreReplaced) {
    for (const Json& material :
         {Json{{"pbrMetallicRoughness", {{"baseColorFactor", {1e300, 0, 0, 1}}}}},
          Json{{"emissiveFactor", {0, -1, 0}}}}) {
        Gltf gltf = one_triangle();
        gltf.json["materials"] = {material};
        gltf.primitive(0)["material"] = 0;
        const auto scene = load_glb(gltf);
        ASSERT_TRUE(scene) << material;
        EXPECT_TRUE(says(scene, "material 0 is replaced by glTF's default material: its '"))
            << material;
        EXPECT_EQ(scene->materials[0].emission, Color3f(0.0F));
    }
}

TEST_F(Limits, VerticesOfObjBeyondTheRangeAreLeftOut) {
    const std::string near = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const auto scene = load_obj(near + "v 1e18 0 0\nf 1 2 3\nf 1 2 4\n");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->triangle_count(), 1U);
    EXPECT_TRUE(says(scene, "1 face skipped because of a vertex that is not finite or too large"));
    EXPECT_TRUE(load_obj(near + "v 0 1e12 0\nf 1 2 4\n"));
}

// 4096 instances of 2^16 vertices have their exact box, one more has that of the mesh's box.
TEST_F(Limits, BoundsOfTooManyVerticesAreThoseOfBoxes) {
    Scene scene;
    scene.meshes.resize(1);
    // A diagonal: its box has corners that are not on it.
    scene.meshes[0].edit().positions = {V3f(0.0F), V3f(1.0F)};
    M44d turned;
    turned.rotate(V3d(0.0, 0.0, 0.5));
    scene.instances = {{MeshIndex(0), turned, 0}};
    const V3d end = V3d(1.0, 1.0, 1.0) * turned;
    EXPECT_EQ(scene.bounds().max, V3f(end));
    scene.meshes[0].edit().positions.resize(std::size_t{1} << 16U, V3f(0.0F));
    scene.instances.resize(4097, scene.instances[0]);
    const V3d right = V3d(1.0, 0.0, 1.0) * turned;
    ASSERT_GT(right.x, end.x);
    EXPECT_EQ(scene.bounds().max, V3f(V3d(right.x, end.y, 1.0)));
}

}  // namespace balcony::scene::testing::limits_test
