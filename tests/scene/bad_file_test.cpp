// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <limits>
#include <string>
#include <utility>

#include "../laws/scene_laws.hpp"
#include "scene_files.hpp"

namespace balcony::scene::testing::bad_file_test {

namespace {

using BadFiles = SceneFiles;

// Loading must fail, with this in what is said.
::testing::AssertionResult fails(const Result<Scene>& result, std::string_view text) {
    if (result) {
        return ::testing::AssertionFailure() << "was loaded";
    }
    if (!has_errors(result.diagnostics)) {
        return ::testing::AssertionFailure() << "no error was given";
    }
    return says(result, text);
}

}  // namespace

TEST_F(BadFiles, MissingFileSuggestsTheNearest) {
    write("room.glb", one_triangle().glb());
    const auto result = load(folder / "rooom.glb");
    EXPECT_TRUE(fails(result, "there is no file '"));
    EXPECT_TRUE(says(result, "did you mean '" + (folder / "room.glb").string() + "'?"));
    EXPECT_TRUE(fails(load(folder / "nowhere" / "x.glb"), "there is no file '"));
}

TEST_F(BadFiles, DirectoryAndUnknownExtension) {
    EXPECT_TRUE(fails(load(folder.path()), "is a folder, not a file"));
    std::filesystem::create_directory(folder / "folder.glb");
    EXPECT_TRUE(fails(load(folder / "folder.glb"), "is a folder"));
    const auto unknown = load(write("scene.txt", "words"));
    EXPECT_TRUE(fails(unknown, "scene.txt' is not supported"));
    EXPECT_TRUE(says(unknown, "formats .glb, .gltf, .obj, .ply, .stl"));
}

TEST_F(BadFiles, OtherFormatsNameTheExportThatHelps) {
    const auto advice_for = [&](const std::string& name) {
        const auto result = load(write(name, "bytes"));
        EXPECT_TRUE(fails(result, name + "' is not supported"));
        return said(result);
    };
    EXPECT_NE(advice_for("a.blend").find("File > Export > glTF 2.0"), std::string::npos);
    for (const char* name : {"a.fbx", "a.dae", "a.usd", "a.usdc", "a.FBX", "a.3ds"}) {
        EXPECT_NE(advice_for(name).find("import it into Blender"), std::string::npos) << name;
    }
    EXPECT_NE(advice_for("part.step").find("FreeCAD"), std::string::npos);
    EXPECT_NE(advice_for("scan.las").find("points are not rendered"), std::string::npos);
    EXPECT_NE(advice_for("room.glb.zip").find("extract"), std::string::npos);
}

// A byte order mark of UTF-8 is no part of the text, and UTF-16 is said to be what it is.
TEST_F(BadFiles, AllTextsBeginAlike) {
    const std::string facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
        "vertex 0 1 0\nendloop\nendfacet\n";
    const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";
    const std::pair<const char*, std::string> texts[]{
        {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"a.stl", "solid a\n" + facet + "endsolid\n"},
        {"a.ply",
         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
         "end_header\n" +
             corners + "3 0 1 2\n"},
        {"a.gltf", R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
                   R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[)"
                   R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],)"
                   R"("max":[1,1,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[)"
                   R"({"byteLength":36,"uri":"data:application/octet-stream;base64,)"
                   R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})"}};
    for (const auto& [name, text] : texts) {
        const auto marked = load(write(name, "\xef\xbb\xbf" + text));
        ASSERT_TRUE(marked) << name << said(marked);
        EXPECT_EQ(marked->triangle_count(), 1U) << name;
        EXPECT_EQ(marked->bounds().max, V3f(1, 1, 0)) << name;
        std::string wide = "\xff\xfe";
        for (const char c : text) {
            wide += std::string{c, '\0'};
        }
        EXPECT_TRUE(fails(load(write(name, wide)), std::string(name) + "' is UTF-16")) << name;
    }
}

TEST_F(BadFiles, TruncatedGlbReportsBothSizes) {
    const std::string glb = one_triangle().glb();
    const auto result = load(write("cut.glb", glb.substr(0, glb.size() - 10)));
    EXPECT_TRUE(fails(result, "cut.glb' is truncated: it declares " + std::to_string(glb.size()) +
                                  " bytes and has " + std::to_string(glb.size() - 10)));
    for (std::size_t size = 0; size < glb.size(); ++size) {
        EXPECT_TRUE(fails(load(write("cut.glb", glb.substr(0, size))),
                          size < 4 ? "is not a GLB" : "is truncated: it declares "))
            << size;
    }
}

TEST_F(BadFiles, NotAGlb) {
    EXPECT_TRUE(fails(load(write("a.glb", "PNG or so")), "a.glb' is not a GLB"));
    const auto json = load(write("b.glb", "{}"));
    EXPECT_TRUE(fails(json, "is not a GLB"));
    EXPECT_TRUE(says(json, "name it .gltf"));
    EXPECT_TRUE(fails(load(write("c.glb", "")), "is not a GLB"));
    std::string old = one_triangle().glb();
    old[4] = 1;
    EXPECT_TRUE(fails(load(write("d.glb", old)), "is glTF version 1"));
}

TEST_F(BadFiles, BrokenJsonShowsThePlace) {
    const auto result = load(write("scene.gltf", "{\n  \"asset\": {\"version\" \"2.0\"}\n}"));
    EXPECT_TRUE(fails(result, "scene.gltf:2:"));
    EXPECT_TRUE(says(result, "the JSON of '"));
    EXPECT_TRUE(says(result, "expected ':' here"));
    EXPECT_TRUE(fails(load(write("e.gltf", "")), "the JSON of '"));
    for (const char* const number : {"NaN", "nan", "Infinity", "-Infinity"}) {
        const auto scene = load(write("o.gltf", "{\"emissiveFactor\": [" + std::string(number)));
        EXPECT_TRUE(fails(scene, "o.gltf:1:2")) << number;
        EXPECT_TRUE(says(scene, "JSON has no number ")) << number;
    }
    const auto infinite = load(write("n.gltf", "{\n\"emissiveStrength\": -1e999}"));
    EXPECT_TRUE(fails(infinite, "n.gltf' has the number -1e999, which is too large"));
    EXPECT_TRUE(says(infinite, "n.gltf:2:21"));
    EXPECT_TRUE(says(infinite, "numbers of light are at most 1e+30"));
    EXPECT_TRUE(fails(load(write("deep.gltf", std::string(1000000, '['))), "the JSON of '"));
    EXPECT_TRUE(fails(load(write("bare.gltf", "[]")), "has no 'asset' with a 'version'"));
    EXPECT_TRUE(fails(load(write("old.gltf", R"({"asset": {"version": "1.0"}})")),
                      "is glTF version '1.0'"));
}

TEST_F(BadFiles, NothingToRender) {
    EXPECT_TRUE(fails(load_glb(Gltf()), "nothing to render in '"));
    EXPECT_TRUE(says(load_glb(Gltf()), "scene.glb': it has no triangles"));
    EXPECT_TRUE(fails(load_obj(""), "scene.obj': it has no triangles"));
    EXPECT_TRUE(fails(load_obj("v 0 0 0\nv 1 0 0\nl 1 2\n"), "nothing to render"));
}

TEST_F(BadFiles, VerticesThatAreNoNumbers) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {nan, infinity, -infinity, 3e38F}) {
        Gltf gltf = one_triangle();
        gltf.primitive(0)["attributes"] = {
            {"POSITION", gltf.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, bad, 0}, 3)}};
        gltf.primitive(0)["indices"] = gltf.add_shorts({0, 1, 2, 0, 1, 3, 3, 2, 1}, 1);
        const auto scene = load_glb(gltf);
        ASSERT_TRUE(scene) << said(scene);
        EXPECT_EQ(scene->triangle_count(), 1U);
        EXPECT_EQ(scene->bounds().max, V3f(1, 1, 0));
        EXPECT_TRUE(
            says(scene,
                 "mesh 'mesh': 2 triangles skipped because of a vertex that is not finite or "
                 "too large"));
    }
}

TEST_F(BadFiles, IndicesOutOfRange) {
    Gltf gltf = one_triangle();
    gltf.primitive(0)["indices"] = gltf.add_shorts({0, 1, 2, 0, 1, 3, 65535, 1, 0}, 1);
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->triangle_count(), 1U);
    EXPECT_TRUE(says(scene, "mesh 'mesh': 2 triangles skipped because of a vertex index"));
}

TEST_F(BadFiles, AccessorsThatReachTooFar) {
    Gltf gltf = one_triangle();
    gltf.json["accessors"][0]["count"] = 4;
    EXPECT_TRUE(fails(load_glb(gltf),
                      "mesh 'mesh': primitive 0 is skipped: an accessor extends "
                      "past the end of its buffer view"));
    // Sums of these with anything wrap around.
    const std::string skipped = "mesh 'mesh': primitive 0 is skipped: ";
    for (const std::uint64_t huge : {0xffffffffffffffffULL, 0xfffffffffffffff8ULL, 1ULL << 62U}) {
        const std::pair<const char*, const char*> changes[] = {
            {"/accessors/0/count", "an accessor extends past the end of its buffer view"},
            {"/accessors/0/byteOffset", "an accessor extends past the end"},
            {"/accessors/0/bufferView", "the file has no 'bufferViews' with index "},
            {"/bufferViews/0/byteLength", "buffer view 0 extends past the end of buffer 0"},
            {"/bufferViews/0/byteOffset", "buffer view 0 extends past the end of buffer 0"},
            {"/bufferViews/0/buffer", "buffer view 0 refers to a missing buffer"},
            {"/bufferViews/0/byteStride", "an accessor extends past the end"}};
        for (const auto& [place, reason] : changes) {
            Gltf wraps = one_triangle();
            wraps.json[Json::json_pointer(place)] = huge;
            EXPECT_TRUE(fails(load_glb(wraps), skipped + reason)) << place;
        }
    }
    Gltf without_bytes = one_triangle();
    without_bytes.json["accessors"][0].erase("bufferView");
    without_bytes.json["accessors"][0]["count"] = 4000000000U;
    EXPECT_TRUE(fails(load_glb(without_bytes), "an accessor without a buffer view has more"));
}

TEST_F(BadFiles, WrongKindsInTheJson) {
    const Json odd[] = {nullptr, true, -1, 1.5, "text", Json::array(), Json::object(), {1, 2}};
    for (const Json& value : odd) {
        for (const char* key : {"/nodes/0/mesh", "/nodes/0/children", "/meshes/0/primitives",
                                "/meshes/0/primitives/0/attributes", "/accessors/0/type",
                                "/accessors/0/componentType", "/bufferViews/0/byteOffset",
                                "/scenes/0/nodes", "/nodes/0", "/nodes", "/accessors", "/scene"}) {
            Gltf gltf = one_triangle();
            gltf.json[Json::json_pointer(key)] = value;
            const auto result = load_glb(gltf);
            EXPECT_EQ(laws::broken_law(result), "") << key << value;
            // None of these values is right but where it means that there is nothing.
            EXPECT_TRUE(!result || !result.diagnostics.empty() || value.empty()) << key << value;
        }
    }
}

TEST_F(BadFiles, ExternalBuffer) {
    const Gltf gltf = one_triangle();
    Json json = gltf.json;
    json["buffers"] = {{{"uri", "data.bin"}, {"byteLength", gltf.buffer.size()}}};
    const auto missing = load(write("scene.gltf", json.dump()));
    EXPECT_TRUE(fails(missing,
                      "there is no file '" + (folder / "data.bin").string() + "', which contains"));
    write("data.bin", gltf.buffer.substr(0, 20));
    EXPECT_TRUE(fails(load(folder / "scene.gltf"), "it contains 20 of "));
}

TEST_F(BadFiles, MissingBufferBesideTheScene) {
    Json json = one_triangle().json;
    json["buffers"] = {{{"uri", "textured_box.bin"}, {"byteLength", 3}}};
    const auto file = write("textured_box.gltf", json.dump());
    EXPECT_FALSE(says(load(file), "did you mean"));
    write("texturd_box.bin", "abc");
    EXPECT_TRUE(says(load(file), "did you mean '" + (folder / "texturd_box.bin").string()));
}

// A scene cannot name files outside its folder, however they are written.
TEST_F(BadFiles, FilesOutsideTheFolderAreNotRead) {
    std::filesystem::create_directories(folder / "scene" / "maps");
    write("secret.bin", std::string(64, 'x'));
    write("scene/maps/inside.png", "");
    Gltf gltf = one_triangle();
    gltf.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.primitive(0)["material"] = 0;
    gltf.primitive(0)["attributes"]["TEXCOORD_0"] = gltf.add_floats({0, 0, 1, 0, 0, 1}, 2);
    const auto load_with_image = [&](const std::string& uri) {
        gltf.json["images"] = {{{"uri", uri}}};
        return load(write("scene/scene.glb", gltf.glb()));
    };
    const std::string absolute = (folder / "secret.bin").string();
    for (const std::string& uri :
         {std::string("../secret.bin"), std::string("..\\secret.bin"), absolute,
          std::string("maps/../../secret.bin"), std::string("%2e%2e/secret.bin"),
          "file://" + absolute, std::string("https://example.org/a.png")}) {
        const auto scene = load_with_image(uri);
        ASSERT_TRUE(scene) << uri;
        EXPECT_TRUE(scene->textures.empty()) << uri;
        EXPECT_TRUE(says(scene, uri.find("://") != std::string::npos
                                    ? "is an address, which is not opened"
                                    : "is outside the folder of the scene"))
            << uri;
        EXPECT_TRUE(says(scene, "into")) << "a remedy";
    }
    for (const std::string uri :
         {"maps/inside.png", "maps/../maps/inside.png", "./maps/inside.png"}) {
        const auto scene = load_with_image(uri);
        ASSERT_TRUE(scene) << uri;
        EXPECT_EQ(scene->textures.size(), 1U) << uri << said(scene);
    }

    Json json = one_triangle().json;
    json["buffers"] = {{{"uri", "../secret.bin"}, {"byteLength", 64}}};
    const auto no_geometry = load(write("scene/scene.gltf", json.dump()));
    EXPECT_TRUE(fails(no_geometry, "is outside the folder of the scene"));
    EXPECT_TRUE(says(no_geometry, "copy it into that folder"));

    write("secret.mtl", "newmtl m\nKd 1 0 0\n");
    const auto obj = load(
        write("scene/scene.obj", "mtllib ../secret.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    ASSERT_TRUE(obj) << said(obj);
    EXPECT_TRUE(says(obj, "material library skipped: '"));
    EXPECT_TRUE(says(obj, "is outside the folder of the scene"));
}

TEST_F(BadFiles, TrianglesWithoutAreaAreCounted) {
    const auto scene =
        load_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 0 0 0\nf 1 2 3\nf 1 2 4\nf 1 5 3\n");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->triangle_count(), 1U);
    EXPECT_TRUE(says(scene, ".obj': 2 triangles without area skipped"));
}

// A file of a thousand meshes has one warning, not a thousand.
TEST_F(BadFiles, WhatIsWrongWithManyMeshesIsOneWarning) {
    Gltf gltf = one_triangle();
    gltf.primitive(0)["attributes"] = {
        {"POSITION", gltf.add_floats({0, 0, 0, 3, 0, 4, 0, 1, 0}, 3)},
        {"NORMAL", gltf.add_floats({0, 0, 0, 0, 0, 7, 0, 0, 0}, 3)}};
    for (const char* name : {"second", "third"}) {
        gltf.json["meshes"].push_back(gltf.json["meshes"][0]);
        gltf.json["meshes"].back()["name"] = name;
        gltf.add_node({{"mesh", gltf.json["meshes"].size() - 1}});
    }
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(says(scene, "mesh 'mesh' and 2 others: 6 normals of length 0 replaced"));
    EXPECT_EQ(scene.diagnostics.size(), 1U) << said(scene);
}

// However small a triangle is, it is one.
TEST_F(BadFiles, TinyTrianglesHaveArea) {
    const auto scene = load_obj("v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nf 1 2 3\n");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->meshes[0]->normals[0], V3f(0, 0, 1));
}

TEST_F(BadFiles, NodeTransforms) {
    Gltf gltf = one_triangle();
    Json matrix = Json::array();
    for (int i = 0; i < 16; ++i) {
        matrix.push_back(nullptr);  // How writers put NaN.
    }
    gltf.add_node({{"name", "none"}, {"mesh", 0}, {"matrix", matrix}});
    gltf.add_node({{"name", "flat"}, {"mesh", 0}, {"scale", {1, 0, 1}}});
    gltf.add_node({{"name", "huge"}, {"scale", {1e300, 1e300, 1e300}}, {"children", {4}}});
    gltf.add_node({{"name", "huger"}, {"mesh", 0}, {"scale", {1e300, 1, 1}}}, false);
    gltf.add_node({{"name", "unturned"}, {"mesh", 0}, {"rotation", {0, 0, 0, 0}}});
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->instances.size(), 1U);
    EXPECT_TRUE(says(scene, "node 'none' is skipped: its 'matrix' is not a number"));
    EXPECT_TRUE(says(scene, "node 'flat' is skipped: its transform is singular"));
    EXPECT_TRUE(says(scene, "node 'huger' is skipped: its transform is not finite"));
    EXPECT_TRUE(says(scene, "node 'unturned' is skipped: its 'rotation' has length 0"));
}

TEST_F(BadFiles, NodesInACircle) {
    Gltf gltf = one_triangle();
    gltf.json["nodes"][0]["children"] = {0};
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->instances.size(), 1U);
    EXPECT_TRUE(
        says(scene, "node 'node' is skipped: it has more than one parent, or is its own parent"));
}

TEST_F(BadFiles, CompressedGeometryIsNamed) {
    Gltf gltf = one_triangle();
    gltf.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    EXPECT_TRUE(fails(load_glb(gltf), "requires the extension 'KHR_draco_mesh_compression'"));
}

TEST_F(BadFiles, RepeatedWarningsAreLimited) {
    Gltf gltf = one_triangle();
    for (int i = 0; i < 500; ++i) {
        gltf.add_node({{"mesh", 0}, {"scale", {0, 1, 1}}});
    }
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene.diagnostics.size(), 51U);
    EXPECT_TRUE(says(scene, "450 warnings more like these"));
}

TEST_F(BadFiles, NamesAreFitToPrint) {
    Gltf gltf = one_triangle();
    gltf.add_node({{"name", "\x1b[31m"}, {"mesh", 0}, {"scale", {0, 1, 1}}});
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene);
    EXPECT_TRUE(says(scene, "node '?[31m' is skipped"));
}

}  // namespace balcony::scene::testing::bad_file_test
