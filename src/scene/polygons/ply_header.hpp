// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace balcony::scene {

enum class PlyType : std::uint8_t {
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    float32,
    float64,
};

[[nodiscard]] std::size_t size_of(PlyType type);

enum class PlyEncoding : std::uint8_t { text, little_endian, big_endian };

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    std::optional<PlyType> list_count;  ///< The type of a list's length; nothing if it is no list.
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::text;
    std::vector<PlyElement> elements;
};

/// Removes the header from the beginning of a file. Throws ReadError with a reason that names the
/// line if it is malformed.
[[nodiscard]] PlyHeader take_ply_header(std::string_view& text, std::string_view file);

}  // namespace balcony::scene
