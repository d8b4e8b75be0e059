// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Small scene files for tests, written into a folder of the test's own.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../files/temporary_folder.hpp"
#include "balcony/scene.hpp"

namespace balcony::scene::testing {

using Json = nlohmann::json;

/// A glTF document with its one buffer. Starts out as a document with no nodes in its scene.
class Gltf {
public:
    Gltf();

    Json json;
    std::string buffer;

    /// Append data, and return the new accessor.
    std::size_t add_floats(const std::vector<float>& values, std::size_t components);
    std::size_t add_shorts(const std::vector<std::uint16_t>& values, std::size_t components,
                           bool normalized = false);
    std::size_t add_accessor(std::string_view bytes, const Json& accessor);

    /// A mesh of one right triangle (0,0,0) (1,0,0) (0,1,0) with normals +z and indices.
    std::size_t add_triangle(const std::string& name);

    /// A node; root nodes are in the scene.
    std::size_t add_node(const Json& node, bool root = true);

    [[nodiscard]] std::string glb() const;
    [[nodiscard]] Json& primitive(std::size_t mesh) {
        return json["meshes"][mesh]["primitives"][0];
    }
};

/// One triangle in one node named "node".
[[nodiscard]] Gltf one_triangle();

/// A new folder for each test, with helpers to load what is written there.
class SceneFiles : public ::testing::Test {
protected:
    std::filesystem::path write(const std::string& name, std::string_view bytes) const;
    [[nodiscard]] Result<Scene> load_glb(const Gltf& gltf) const;
    [[nodiscard]] Result<Scene> load_obj(std::string_view text) const;

    const files::TemporaryFolder folder;
};

/// All messages and remedies, one a line.
[[nodiscard]] std::string said(const Result<Scene>& result);

::testing::AssertionResult says(const Result<Scene>& result, std::string_view text);

}  // namespace balcony::scene::testing
