// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Common parts of the scene readers: the scene under construction, files, names in messages.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/names.hpp"
#include "balcony/progress.hpp"
#include "balcony/scene.hpp"
#include "scene/part_error.hpp"

namespace balcony::scene {

/// Thrown inside this layer when nothing can be rendered; load() returns it as an error.
struct ReadError {
    Diagnostic diagnostic;
};

/// Thrown inside this layer when a stop is requested; load() returns it as an error.
struct Stopped {};

/// What was repaired or left out in several meshes, such as the triangles of an invalid index.
struct MeshFault {
    std::string_view noun;  ///< "triangle"
    std::string_view what;  ///< "skipped because ..."
    std::size_t count = 0;
    std::size_t meshes = 0;
    std::string first_mesh;
};

/// A scene under construction, with its diagnostics.
struct Import {
    std::filesystem::path file;
    /// The bytes of the file, if given in memory.
    std::optional<std::span<const std::uint8_t>> given;
    LoadOptions options;
    std::stop_token stop;
    PartDone progress;
    Scene scene;
    Diagnostics diagnostics;
    std::size_t further_warnings = 0;
    std::size_t triangles_without_area = 0;  ///< Skipped.
    std::size_t coincident_triangles = 0;    ///< Skipped.
    std::vector<MeshFault> mesh_faults;      ///< One for each `what`.
    bool is_of_blender = false;              ///< Its lights are in lm/W times Blender's watts.

    static constexpr std::size_t max_warnings = 50;

    /// Adds a warning, or only counts it if there are too many.
    void warn(std::string message, std::string remedy = {});
    /// Counts what is wrong with a mesh. The whole file gets one warning for each `what`.
    void count_fault(const std::string& mesh, std::string_view noun, std::size_t count,
                     std::string_view what);
    /// Whether a texture is a file; otherwise warns that its user, such as "material 'm'", has
    /// none.
    [[nodiscard]] bool has_texture(const std::filesystem::path& texture, const std::string& user);
    [[nodiscard]] bool adds_warnings() const { return diagnostics.size() < max_warnings; }
    /// The bytes of the file. Throws ReadError if it cannot be read.
    [[nodiscard]] std::vector<std::uint8_t> bytes();
    /// All bytes of a regular file. Throws ReadError if there is none, or if it cannot be read.
    [[nodiscard]] std::vector<std::uint8_t> bytes_of(const std::filesystem::path& other);
    /// "did you mean 'x.bin'?" if the folder of a missing file has a similar name, other than that
    /// of the file itself.
    [[nodiscard]] std::optional<std::string> near_name(const std::filesystem::path& missing) const;

    /// Throws Stopped if a stop is requested.
    void check_stop() const;
    /// What follows is the part of loading from `begin` to `end`.
    void begin_phase(double begin, double end);
    /// Within a phase: checks for a stop and reports progress, at once or, for bytes and elements
    /// that take no time by themselves, now and then.
    void report(std::size_t done, std::size_t total);
    void go_on(std::size_t done, std::size_t total) {
        if (done >= next_report_) {
            report(done, total);
        }
    }
    /// The path of a file of this scene that `other` names, relative to the folder of that file.
    /// Throws PartError unless it is in the folder of the scene or below: a scene that was
    /// downloaded must not show other files of the machine.
    [[nodiscard]] std::filesystem::path beside(const std::filesystem::path& other,
                                               std::string_view written);

private:
    double phase_begin_ = 0.0;
    double phase_end_ = 1.0;
    double reported_ = 0.0;
    std::size_t next_report_ = 0;
};

/// Warns once of what is wrong with meshes, for all of a file, and drops instances beyond
/// max_coincident.
void warn_of_meshes(Import& import);

/// Treats closed objects of thin glass as LoadOptions::solid_glass says.
void treat_glass(Import& import);

/// The readers of the formats. They throw ReadError.
void read_gltf(Import& import);
void read_obj(Import& import);
void read_ply(Import& import);
void read_stl(Import& import);

/// How to make a scene file that is read of one with another extension, in lower case.
[[nodiscard]] std::string advice_on_format(std::string_view extension);

/// A name in quotes for a message: without control characters, shortened if very long.
[[nodiscard]] std::string in_quotes(std::string_view name);
}  // namespace balcony::scene
