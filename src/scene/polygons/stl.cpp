// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "balcony/input_file.hpp"
#include "scene/polygons/face_set.hpp"
#include "scene/polygons/words.hpp"

namespace balcony::scene {

namespace {

using Bytes = std::span<const std::uint8_t>;

// A binary file: 80 bytes of any content, the number of triangles, and for each of them a normal,
// three corners and two bytes of any content.
constexpr std::size_t header_size = 84;
constexpr std::size_t triangle_size = 50;
constexpr std::size_t corners_at = 12;

std::uint32_t integer_at(Bytes bytes, std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8U |
           static_cast<std::uint32_t>(bytes[at + 2]) << 16U |
           static_cast<std::uint32_t>(bytes[at + 3]) << 24U;
}

float float_at(Bytes bytes, std::size_t at) { return std::bit_cast<float>(integer_at(bytes, at)); }

class StlReader {
public:
    explicit StlReader(Import& import) : import_(import) {
        begin_solid(import.file.stem().string());
    }

    void read(Bytes bytes) {
        if (is_binary(bytes)) {
            read_binary(bytes);
        } else {
            read_text(text_of(bytes, import_.file));
        }
        set_.warn_of_skipped(import_);
    }

    FaceSet take() { return std::move(set_); }

private:
    // The header of a binary file may also begin with "solid", so the size decides.
    static bool is_binary(Bytes bytes) {
        std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        const bool may_be_text = begin_text(text, "").has_value() || text.starts_with("solid");
        return bytes.size() >= header_size &&
               (!may_be_text ||
                header_size + triangle_size * std::size_t{integer_at(bytes, 80)} == bytes.size());
    }

    void begin_solid(std::string name) {
        const auto number = static_cast<std::uint32_t>(set_.sections.size());
        set_.sections.push_back({std::move(name), MaterialIndex(0), number});
    }

    void add_triangle(const std::array<V3f, 3>& points) {
        const auto first = static_cast<std::uint32_t>(set_.positions.size());
        set_.positions.insert(set_.positions.end(), points.begin(), points.end());
        std::array<Corner, 3> corners{Corner{first}, Corner{first + 1}, Corner{first + 2}};
        set_.add_polygon(corners, smooth_by_angle,
                         static_cast<std::uint32_t>(set_.sections.size() - 1));
    }

    void read_binary(Bytes bytes) {
        const std::size_t stated = integer_at(bytes, 80);
        const std::size_t count = std::min(stated, (bytes.size() - header_size) / triangle_size);
        set_.positions.reserve(3 * count);
        set_.faces.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            import_.go_on(i, count);
            std::array<V3f, 3> points;
            for (std::size_t k = 0; k < 9; ++k) {
                points[k / 3][static_cast<int>(k % 3)] = float_at(
                    bytes, header_size + i * triangle_size + corners_at + k * sizeof(float));
            }
            add_triangle(points);
        }
        if (count < stated) {
            import_.warn(
                fmt::format("the file ends after {} of its {}", count, counted(stated, "triangle")),
                "export it again");
        }
    }

    void read_text(std::string_view text) {
        std::vector<V3f> points;
        std::string joined;
        std::size_t incomplete = 0;
        const std::size_t size = text.size();
        while (!text.empty()) {
            import_.go_on(size - text.size(), size);
            auto [keyword, arguments] = take_statement(text, joined);
            if (is(keyword, "vertex")) {
                V3f point;
                points.push_back(take_vector(arguments, point)
                                     ? point
                                     : V3f(std::numeric_limits<float>::quiet_NaN()));
            } else if (is(keyword, "endfacet")) {
                if (points.size() == 3) {
                    add_triangle({points[0], points[1], points[2]});
                } else {
                    ++incomplete;
                }
                points.clear();
            } else if (is(keyword, "solid") && !arguments.empty()) {
                begin_solid(std::string(arguments));
            }
        }
        if (incomplete > 0) {
            import_.warn(
                fmt::format("{} skipped without exactly 3 corners", counted(incomplete, "facet")));
        }
    }

    // Keywords may be in capitals.
    static bool is(std::string_view keyword, std::string_view expected) {
        return std::equal(keyword.begin(), keyword.end(), expected.begin(), expected.end(),
                          [](unsigned char a, char b) { return std::tolower(a) == b; });
    }

    Import& import_;
    FaceSet set_;
};

FaceSet read_stl_faces(Import& import) {
    import.begin_phase(0.0, text_begins);
    const std::vector<std::uint8_t> bytes = import.bytes();
    import.begin_phase(text_begins, normals_begin);
    StlReader reader(import);
    reader.read(bytes);
    return reader.take();
}

}  // namespace

void read_stl(Import& import) {
    import.scene.format = "STL";
    import.scene.axes = Axes::z_up;
    import.scene.materials.emplace_back();
    add_to_scene(read_stl_faces(import), import);
}

}  // namespace balcony::scene
