// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Data: files that a camera file names in quotation marks: tables of numbers, grey images, meshes,
// maps of rays and of picture positions, calibrated cameras, lenses.
//
// Limits prevent a wrong file from filling the memory; a file beyond a limit is an error.

#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/catalogue.hpp"
#include "balcony/npy.hpp"
#include "balcony/prescription.hpp"

namespace balcony::data {

inline constexpr std::size_t max_table = 16'000'000;        ///< Bytes.
inline constexpr std::size_t max_numbers = 262'144;         ///< Of a table.
inline constexpr std::size_t max_pixels = 16'777'216;       ///< Of an image.
inline constexpr std::size_t max_map_file = 1'500'000'000;  ///< Bytes.
inline constexpr std::size_t max_mesh_file = 500'000'000;   ///< Bytes.
inline constexpr std::size_t max_calibration = 4'000'000;   ///< Bytes.
inline constexpr std::size_t max_prescription = 1'000'000;  ///< Bytes.
inline constexpr std::size_t max_triangles = 5'000'000;     ///< Of a mesh.

/// A file on the disk, or one whose bytes are in memory: one that comes with Balcony, or what was
/// read from standard input.
struct File {
    std::string name;            ///< For messages.
    std::filesystem::path path;  ///< Of bytes in memory, its extension alone matters.
    std::optional<std::span<const std::uint8_t>> bytes{};

    [[nodiscard]] static File on_disk(const std::filesystem::path& path) {
        return {path.string(), path};
    }
    /// The bytes must live as long as the file.
    [[nodiscard]] static File in_memory(std::string name, std::filesystem::path path,
                                        std::span<const std::uint8_t> bytes) {
        return {std::move(name), std::move(path), bytes};
    }
};

/// Finds a file by its name in a camera file: in a folder, if one is given,
/// then among the built-in files. An error names the path that was tried and the
/// nearest existing name.
[[nodiscard]] Result<File> find_file(std::string_view name,
                                     const std::optional<std::filesystem::path>& folder);
/// The built-in files (cameras/data), sorted by name.
[[nodiscard]] std::vector<std::string> built_in_files();

/// A table as text has it, row by row.
struct NumberTable {
    struct Number {
        double value = 0.0;  ///< In radians if it is an angle.
        bool angle = false;  ///< It has the unit deg or rad.
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
[[nodiscard]] Result<NumberTable> read_table(const File& file);

/// Points of a file, in batches of bounded memory, however many there are: an array of NumPy (.npy)
/// of the shape (points, 3), or lines of three lengths as in a table. One thread at a time.
class PointReader {
public:
    /// An error if it is no regular file.
    [[nodiscard]] static Result<PointReader> open(const std::filesystem::path& file);
    /// The stream must outlive the reader; `name` is for messages.
    PointReader(std::istream& stream, std::string name);

    /// The next points, at most 87 381; none behind the last one. A file without points is an
    /// error.
    [[nodiscard]] Result<std::vector<Imath::V3d>> next();

private:
    PointReader(std::unique_ptr<std::istream> stream, std::string name);
    [[nodiscard]] Diagnostics begin();
    void fill(std::size_t size);
    [[nodiscard]] std::string next_lines();
    [[nodiscard]] Result<std::vector<Imath::V3d>> next_rows();
    [[nodiscard]] Result<std::vector<Imath::V3d>> next_of_array();
    [[nodiscard]] std::optional<std::string> numbers(std::size_t count);

    std::unique_ptr<std::istream> own_;
    std::istream* stream_;
    std::string name_;
    std::string buffer_;  ///< Bytes that were read and not used.
    std::optional<NpyHeader> header_;
    bool begun_ = false;
    std::size_t lines_ = 0;   ///< Of a text, before the buffer.
    std::size_t points_ = 0;  ///< That were given.
};

/// Reads an image in any format that ImageFile opens. Grey is the luma of the colours as they are
/// stored, by Rec. 709, times alpha.
[[nodiscard]] Result<std::shared_ptr<const camera::GreyImage>> read_grey_image(const File& file);

/// Reads all meshes of a scene file (scene::file_extensions()) as one, in world positions with z
/// up. u and v are the texture coordinates, with v from the bottom of the image to its top.
/// Triangles without an area in space or in texture coordinates are skipped with a warning.
[[nodiscard]] Result<std::shared_ptr<const camera::TexturedMesh>> read_mesh(const File& file);

/// Reads a ray map as `balcony rays` writes it or as another program does: an EXR file with the
/// channels origin.X, .Y, .Z and direction.X, .Y, .Z, or an array for NumPy (.npy) of the shape
/// (height, width, 6 or more) with these numbers in front. Where valid.A, or the seventh number of
/// an array, is not above one half, and where the direction is 0, there is no ray. Other channels
/// are ignored. A number that is not finite is an error where there is a ray.
[[nodiscard]] Result<std::shared_ptr<const camera::PixelMap>> read_ray_map(const File& file);

/// Reads an STMap, an image whose red is s and whose green is t: a position in another picture,
/// from (0, 0) at its bottom left to (1, 1) at its top right. Where there is an alpha channel and
/// it is not above one half, there is no position.
[[nodiscard]] Result<std::shared_ptr<const camera::PixelMap>> read_st_map(const File& file);

/// Reads calibrated cameras: one from YAML as OpenCV, ROS and their users write it, or all of
/// COLMAP's cameras.txt. The text decides which it is. Missing, unreadable and impossible entries
/// are errors at their line.
[[nodiscard]] Result<std::shared_ptr<const camera::CalibrationFile>> read_calibration(
    const File& file);

/// Reads a lens of glass: Zemax's sequential .zmx, or a table of surfaces as pbrt's .dat, which
/// docs/lenses.md describes. What camera::check() finds is an error at its line.
[[nodiscard]] Result<std::shared_ptr<const camera::Prescription>> read_prescription(
    const File& file);

}  // namespace balcony::data
