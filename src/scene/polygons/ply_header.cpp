// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/polygons/ply_header.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/format.h>

#include "scene/import.hpp"
#include "scene/polygons/words.hpp"

namespace balcony::scene {

namespace {

struct TypeRow {
    PlyType type;
    std::string_view name;
    std::string_view old_name;
    std::size_t size;
};

constexpr std::array types{
    TypeRow{PlyType::int8, "int8", "char", 1},
    TypeRow{PlyType::uint8, "uint8", "uchar", 1},
    TypeRow{PlyType::int16, "int16", "short", 2},
    TypeRow{PlyType::uint16, "uint16", "ushort", 2},
    TypeRow{PlyType::int32, "int32", "int", 4},
    TypeRow{PlyType::uint32, "uint32", "uint", 4},
    TypeRow{PlyType::float32, "float32", "float", 4},
    TypeRow{PlyType::float64, "float64", "double", 8},
};

std::optional<PlyType> type_of(std::string_view name) {
    for (const TypeRow& row : types) {
        if (name == row.name || name == row.old_name) {
            return row.type;
        }
    }
    return std::nullopt;
}

std::optional<PlyEncoding> encoding_of(std::string_view name) {
    return name == "ascii"                  ? std::optional(PlyEncoding::text)
           : name == "binary_little_endian" ? std::optional(PlyEncoding::little_endian)
           : name == "binary_big_endian"    ? std::optional(PlyEncoding::big_endian)
                                            : std::nullopt;
}

// "float x" or "list uchar int vertex_indices"
std::optional<PlyProperty> property_of(std::string_view arguments) {
    PlyProperty property;
    std::string_view word = take_word(arguments);
    if (word == "list") {
        property.list_count = type_of(take_word(arguments));
        if (!property.list_count) {
            return std::nullopt;
        }
        word = take_word(arguments);
    }
    const auto type = type_of(word);
    property.name = take_word(arguments);
    if (!type || property.name.empty()) {
        return std::nullopt;
    }
    property.type = *type;
    return property;
}

std::optional<PlyElement> element_of(std::string_view arguments) {
    PlyElement element;
    element.name = take_word(arguments);
    const std::string_view count = take_word(arguments);
    const auto [stop, code] =
        std::from_chars(count.data(), count.data() + count.size(), element.count);
    return code == std::errc() && !count.empty() && stop == count.data() + count.size()
               ? std::optional(std::move(element))
               : std::nullopt;
}

bool has_element(const PlyHeader& header, std::string_view name) {
    return std::any_of(header.elements.begin(), header.elements.end(),
                       [name](const PlyElement& element) { return element.name == name; });
}

// Whether the line is understood.
bool read_line(const Statement& line, PlyHeader& header) {
    if (line.keyword == "format") {
        std::string_view arguments = line.arguments;
        const auto encoding = encoding_of(take_word(arguments));
        header.encoding = encoding.value_or(header.encoding);
        return encoding.has_value();
    }
    if (line.keyword == "element") {
        auto element = element_of(line.arguments);
        // Of two lists of vertices, one may have properties that the other lacks.
        if (!element || has_element(header, element->name)) {
            return false;
        }
        header.elements.push_back(std::move(*element));
        return true;
    }
    if (line.keyword == "property") {
        auto property = property_of(line.arguments);
        if (property && !header.elements.empty()) {
            header.elements.back().properties.push_back(std::move(*property));
        }
        return property && !header.elements.empty();
    }
    return line.keyword.empty() || line.keyword == "ply" || line.keyword == "comment" ||
           line.keyword == "obj_info";
}

}  // namespace

std::size_t size_of(PlyType type) { return types[static_cast<std::size_t>(type)].size; }

PlyHeader take_ply_header(std::string_view& text, std::string_view file) {
    PlyHeader header;
    if (!text.starts_with("ply")) {
        throw ReadError{error(
            fmt::format("{} is not a PLY file: it does not begin with 'ply'", in_quotes(file)), {},
            "check that it is the right file")};
    }
    std::string joined;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const Statement line = take_statement(text, joined);
        if (line.keyword == "end_header") {
            return header;
        }
        if (!read_line(line, header)) {
            throw ReadError{
                error(fmt::format("line {} of {} is not understood: {}", number, in_quotes(file),
                                  in_quotes(fmt::format("{} {}", line.keyword, line.arguments))),
                      {}, "export the file again")};
        }
    }
    throw ReadError{
        error(fmt::format("the header of {} has no end: 'end_header' is missing", in_quotes(file)),
              {}, "export the file again")};
}

}  // namespace balcony::scene
