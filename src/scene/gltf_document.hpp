// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/gltf_json.hpp"
#include "scene/import.hpp"

namespace balcony::scene {

/// The JSON of a glTF 2.0 file with its buffers. Every access is checked against what is there, so
/// that no file can make us read what it does not hold. Part accesses throw PartError.
class GltfDocument {
public:
    /// Reads a .glb or .gltf file and the buffers beside it. Throws ReadError.
    explicit GltfDocument(const Import& import);

    [[nodiscard]] const Json& root() const { return root_; }
    [[nodiscard]] bool is_binary() const { return is_binary_; }

    /// The bytes of a buffer view.
    [[nodiscard]] std::span<const std::uint8_t> view(std::size_t index) const;

    /// How many elements an accessor has.
    [[nodiscard]] std::size_t count(std::size_t accessor) const;

    /// An accessor's elements one after the other, as floats; normalised integers in 0..1 or -1..1.
    /// Its type must have this number of components.
    [[nodiscard]] std::vector<float> floats(std::size_t accessor, std::size_t components) const;

    /// An accessor of unsigned scalars.
    [[nodiscard]] std::vector<std::uint32_t> integers(std::size_t accessor) const;

private:
    struct Elements;

    void parse(std::string text);
    void read_buffers(std::span<const std::uint8_t> binary_chunk);
    [[nodiscard]] Elements elements(const Json& accessor) const;
    template <class Sink>
    void for_each_component(const Json& accessor, std::size_t components, const Sink& sink) const;
    template <class Sink>
    void replace_sparse(const Json& accessor, std::size_t components, const Sink& sink) const;

    std::filesystem::path file_;
    Json root_;
    bool is_binary_ = false;
    std::vector<std::vector<std::uint8_t>> buffers_;
};

/// The bytes of a "data:" URI in base 64. Throws PartError if it is not one.
[[nodiscard]] std::vector<std::uint8_t> decode_data_uri(std::string_view uri);

/// A relative URI as a path: "%20" is a space.
[[nodiscard]] std::string decode_percent(std::string_view uri);

}  // namespace balcony::scene
