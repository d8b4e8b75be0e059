// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Reads GLB bytes back, as strictly as the format is specified.

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <Imath/ImathBox.h>
#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace balcony::scene::testing {

struct GlbFile {
    nlohmann::json document;
    std::vector<std::uint8_t> binary;
};

inline std::uint32_t word_at(const std::vector<std::uint8_t>& bytes, std::size_t at) {
    return bytes[at] | bytes[at + 1] << 8U | bytes[at + 2] << 16U |
           static_cast<std::uint32_t>(bytes[at + 3]) << 24U;
}

// Fills the file in place, for gtest's fatal assertions need a function without a result.
inline void read_glb(const std::vector<std::uint8_t>& bytes, GlbFile& file) {
    constexpr std::size_t header = 12;
    constexpr std::size_t chunk_header = 8;
    ASSERT_GE(bytes.size(), header + 2 * chunk_header);
    ASSERT_EQ(std::string(bytes.begin(), bytes.begin() + 4), "glTF");
    ASSERT_EQ(word_at(bytes, 4), 2U);
    ASSERT_EQ(word_at(bytes, 8), bytes.size());

    const std::size_t text_size = word_at(bytes, header);
    ASSERT_EQ(text_size % 4, 0U);
    ASSERT_EQ(std::string(bytes.begin() + 16, bytes.begin() + 20), "JSON");
    const std::size_t second = header + chunk_header + text_size;
    ASSERT_LE(second + chunk_header, bytes.size());
    const std::size_t binary_size = word_at(bytes, second);
    ASSERT_EQ(binary_size % 4, 0U);
    ASSERT_EQ(std::memcmp(&bytes[second + 4], "BIN\0", 4), 0);
    ASSERT_EQ(second + chunk_header + binary_size, bytes.size());

    const auto text = bytes.begin() + header + chunk_header;
    file.document =
        nlohmann::json::parse(text, text + static_cast<std::ptrdiff_t>(text_size), nullptr, false);
    ASSERT_FALSE(file.document.is_discarded());
    file.binary.assign(bytes.begin() + static_cast<std::ptrdiff_t>(second + chunk_header),
                       bytes.end());
}

/// The elements of an accessor; Element has the accessor's layout.
template <class Element>
std::vector<Element> elements_of(const GlbFile& file, std::size_t index) {
    const auto& accessor = file.document["accessors"][index];
    const auto& view = file.document["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const auto bytes = view["byteLength"].get<std::size_t>();
    std::vector<Element> elements(bytes / sizeof(Element));
    std::memcpy(static_cast<void*>(elements.data()),
                &file.binary[view["byteOffset"].get<std::size_t>()], bytes);
    return elements;
}

/// Where a node stands, for row vectors; nodes of these files have no parents.
inline Imath::M44d placement(const nlohmann::json& node) {
    Imath::M44d placed;
    if (node.contains("matrix")) {
        const auto numbers = node["matrix"].get<std::vector<double>>();
        std::copy(numbers.begin(), numbers.end(), &placed[0][0]);
    } else if (node.contains("translation")) {
        const auto& t = node["translation"];
        placed.setTranslation(Imath::V3d(t[0], t[1], t[2]));
    }
    return placed;
}

/// The vertices of a node with a mesh, in the world and turned back to z up.
inline std::vector<Imath::V3d> vertices_z_up(const GlbFile& file, const nlohmann::json& node) {
    const auto& primitive =
        file.document["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0];
    const Imath::M44d placed = placement(node);
    std::vector<Imath::V3d> vertices;
    for (const Imath::V3f& position :
         elements_of<Imath::V3f>(file, primitive["attributes"]["POSITION"].get<std::size_t>())) {
        const Imath::V3d p = Imath::V3d(position) * placed;
        vertices.emplace_back(p.x, -p.z, p.y);
    }
    return vertices;
}

inline Imath::Box3d bounds_z_up(const GlbFile& file, const nlohmann::json& node) {
    Imath::Box3d box;
    for (const Imath::V3d& vertex : vertices_z_up(file, node)) {
        box.extendBy(vertex);
    }
    return box;
}

}  // namespace balcony::scene::testing
