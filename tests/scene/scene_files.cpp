// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene_files.hpp"

#include <cstring>

namespace balcony::scene::testing {

namespace {

template <class T>
std::string bytes_of(const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    if (!values.empty()) {
        std::memcpy(bytes.data(), values.data(), bytes.size());
    }
    return bytes;
}

std::string type_of(std::size_t components) {
    return components == 1 ? "SCALAR" : "VEC" + std::to_string(components);
}

void append_word(std::string& bytes, std::size_t word) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
        bytes += static_cast<char>(word >> shift & 0xffU);
    }
}

void append_chunk(std::string& bytes, std::string chunk, std::string_view kind, char padding) {
    chunk.append((4 - chunk.size() % 4) % 4, padding);
    append_word(bytes, chunk.size());
    bytes += kind;
    bytes += chunk;
}

}  // namespace

Gltf::Gltf() {
    json = {{"asset", {{"version", "2.0"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", Json::array()}}}},
            {"nodes", Json::array()},
            {"meshes", Json::array()},
            {"accessors", Json::array()},
            {"bufferViews", Json::array()}};
}

std::size_t Gltf::add_accessor(std::string_view bytes, const Json& accessor) {
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}});
    buffer += bytes;
    buffer.append((4 - buffer.size() % 4) % 4, '\0');
    Json complete = accessor;
    complete["bufferView"] = json["bufferViews"].size() - 1;
    json["accessors"].push_back(complete);
    return json["accessors"].size() - 1;
}

std::size_t Gltf::add_floats(const std::vector<float>& values, std::size_t components) {
    return add_accessor(bytes_of(values), {{"componentType", 5126},
                                           {"count", values.size() / components},
                                           {"type", type_of(components)}});
}

std::size_t Gltf::add_shorts(const std::vector<std::uint16_t>& values, std::size_t components,
                             bool normalized) {
    return add_accessor(bytes_of(values), {{"componentType", 5123},
                                           {"normalized", normalized},
                                           {"count", values.size() / components},
                                           {"type", type_of(components)}});
}

std::size_t Gltf::add_triangle(const std::string& name) {
    const std::size_t positions = add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
    const std::size_t normals = add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
    const std::size_t indices = add_shorts({0, 1, 2}, 1);
    json["meshes"].push_back({{"name", name},
                              {"primitives",
                               {{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
                                 {"indices", indices}}}}});
    return json["meshes"].size() - 1;
}

std::size_t Gltf::add_node(const Json& node, bool root) {
    json["nodes"].push_back(node);
    const std::size_t index = json["nodes"].size() - 1;
    if (root) {
        json["scenes"][0]["nodes"].push_back(index);
    }
    return index;
}

std::string Gltf::glb() const {
    Json complete = json;
    complete["buffers"] = {{{"byteLength", buffer.size()}}};
    std::string chunks;
    append_chunk(chunks, complete.dump(), "JSON", ' ');
    append_chunk(chunks, buffer, std::string_view("BIN\0", 4), '\0');
    std::string bytes = "glTF";
    append_word(bytes, 2);
    append_word(bytes, 12 + chunks.size());
    return bytes + chunks;
}

Gltf one_triangle() {
    Gltf gltf;
    gltf.add_node({{"name", "node"}, {"mesh", gltf.add_triangle("mesh")}});
    return gltf;
}

std::filesystem::path SceneFiles::write(const std::string& name, std::string_view bytes) const {
    return folder.write(name, bytes);
}

Result<Scene> SceneFiles::load_glb(const Gltf& gltf) const {
    return load(write("scene.glb", gltf.glb()));
}

Result<Scene> SceneFiles::load_obj(std::string_view text) const {
    return load(write("scene.obj", text));
}

std::string said(const Result<Scene>& result) {
    std::string text;
    for (const Diagnostic& diagnostic : result.diagnostics) {
        text += to_text(diagnostic);
    }
    return text;
}

::testing::AssertionResult says(const Result<Scene>& result, std::string_view text) {
    if (said(result).find(text) != std::string::npos) {
        return ::testing::AssertionSuccess();
    }
    return ::testing::AssertionFailure() << "expected \"" << text << "\" in:\n" << said(result);
}

}  // namespace balcony::scene::testing
