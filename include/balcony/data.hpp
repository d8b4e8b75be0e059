// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Data: what a camera file names in quotation marks. Tables of numbers, grey images, meshes.
//
// Limits keep a wrong file from filling the memory; what is beyond them is an error that says so.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/catalogue.hpp"

namespace balcony::data {

inline constexpr std::size_t max_table = 16'000'000;       ///< Bytes.
inline constexpr std::size_t max_numbers = 262'144;        ///< Of a table.
inline constexpr std::size_t max_pixels = 16'777'216;      ///< Of an image.
inline constexpr std::size_t max_mesh_file = 500'000'000;  ///< Bytes.
inline constexpr std::size_t max_triangles = 5'000'000;    ///< Of a mesh.

/// A file on the disk, or one that comes with Balcony.
struct File {
    std::string name;  ///< For messages.
    std::filesystem::path path;
    std::optional<std::span<const std::uint8_t>> built_in;  ///< Its bytes if it comes along.
};

/// Finds a file by the name that a camera file gives it: in a folder, if there is one to look in,
/// then among the files that come with Balcony. An error names the path that was tried and the
/// nearest name there is.
[[nodiscard]] Result<File> find_file(std::string_view name,
                                     const std::optional<std::filesystem::path>& folder);
/// The files that come with Balcony (cameras/data), by name.
[[nodiscard]] std::vector<std::string> built_in_files();

/// A table as text has it, row by row.
struct Table {
    struct Number {
        double value = 0.0;  ///< Radians if it is an angle.
        bool angle = false;  ///< It has deg or rad attached.
        std::uint32_t begin = 0, end = 0;
    };

    std::shared_ptr<const SourceText> source;
    std::vector<std::vector<Number>> rows;  ///< None is empty.

    [[nodiscard]] SourceSpan at(const Number& number) const {
        return {source, number.begin, number.end};
    }
};

/// Reads lines of numbers that commas, semicolons, tabs or blanks separate. A '#' begins a comment;
/// a first line without numbers is a header. Numbers may have deg or rad attached.
[[nodiscard]] Result<Table> read_table(const File& file);

/// Reads an image in any format that ImageFile opens. Grey is the luma of the colours as they are
/// stored, by Rec. 709, times alpha.
[[nodiscard]] Result<std::shared_ptr<const camera::GreyImage>> read_grey_image(const File& file);

/// Reads all meshes of a scene file (.obj, .glb, .gltf) as one, in world positions with z up. u and
/// v are the texture co-ordinates, with v from the bottom of the image to its top. Triangles
/// without an area in space or in texture co-ordinates are left out with a warning.
[[nodiscard]] Result<std::shared_ptr<const camera::TexturedMesh>> read_mesh(const File& file);

}  // namespace balcony::data
