// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/budget.hpp"
#include "scene/gltf/data_uri.hpp"
#include "scene/gltf/gltf_accessor.hpp"
#include "scene/gltf/gltf_json.hpp"
#include "scene/import.hpp"

namespace balcony::scene {

/// The JSON of a glTF 2.0 file with its buffers. Every access is checked against the actual sizes,
/// so no file can cause an out-of-bounds read. Part accesses throw PartError.
class GltfDocument {
public:
    /// Reads a .glb or .gltf file and its external buffers. Throws ReadError.
    explicit GltfDocument(Import& import);

    [[nodiscard]] const Json& root() const { return root_; }
    [[nodiscard]] bool is_binary() const { return is_binary_; }

    /// The size of the file in bytes, including its external buffers.
    [[nodiscard]] std::size_t size() const { return size_; }

    /// The 'uri' of a buffer or an image; empty if there is none.
    [[nodiscard]] std::string_view uri_in(const Json& owner) const;

    /// The bytes of a buffer view.
    [[nodiscard]] std::span<const std::uint8_t> view(std::size_t index) const;

    /// An accessor, which must have this number of components. It is read once and its address
    /// is stable.
    [[nodiscard]] const GltfAccessor& accessor(std::size_t index, std::size_t components);

private:
    using Bytes = std::span<const std::uint8_t>;

    void parse(Bytes bytes);
    void read_buffers(Bytes binary_chunk);
    [[nodiscard]] Bytes buffer_bytes(std::string_view uri);
    [[nodiscard]] GltfAccessor read_accessor(const Json& json);

    Import& import_;
    std::vector<std::uint8_t> bytes_;
    LiftedDataUris data_uris_;
    Json root_;
    bool is_binary_ = false;
    std::map<std::filesystem::path, std::vector<std::uint8_t>> files_;  // External files.
    std::deque<std::vector<std::uint8_t>> embedded_;                    // From data URIs.
    std::vector<Bytes> buffers_;
    std::size_t size_ = 0;
    Budget sparse_elements_{0, ""};
    std::map<std::size_t, GltfAccessor> accessors_;
};

/// A relative URI as a path: "%20" is a space.
[[nodiscard]] std::string decode_percent(std::string_view uri);

}  // namespace balcony::scene
