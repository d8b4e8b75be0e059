// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the readers of the scene layer share: the scene in the making, files, names in messages.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/scene.hpp"

namespace balcony::scene {

/// Thrown inside this layer when nothing can be rendered; load() returns it as an error.
struct ReadError {
    Diagnostic diagnostic;
};

/// A scene in the making, with what there is to say about it.
struct Import {
    std::filesystem::path file;
    std::optional<std::span<const std::uint8_t>> given;  ///< Its bytes, if they need no reading.
    Scene scene;
    Diagnostics diagnostics;
    std::size_t further_warnings = 0;

    static constexpr std::size_t max_warnings = 50;

    /// Adds a warning, or counts it if there are so many that one more would bury the others.
    void warn(std::string message, std::string remedy = {});
    /// similar_file() while warnings are added, since it looks through a directory.
    [[nodiscard]] std::string advice_on(const std::filesystem::path& missing) const;
    [[nodiscard]] bool adds_warnings() const { return diagnostics.size() < max_warnings; }
    /// The bytes of the file. Throws ReadError if it cannot be read.
    [[nodiscard]] std::vector<std::uint8_t> bytes() const;
};

/// The two families of formats. Both throw ReadError.
void read_gltf(Import& import);
void read_obj(Import& import);

/// A name in quotes, fit for a message: no control characters, shortened if very long.
[[nodiscard]] std::string in_quotes(std::string_view name);

/// "1 triangle", "12 triangles"
[[nodiscard]] std::string counted(std::size_t count, std::string_view noun);

/// All bytes of a regular file. Throws ReadError if there is none, or if it cannot be read.
[[nodiscard]] std::vector<std::uint8_t> read_bytes(const std::filesystem::path& file);

/// "did you mean 'x.glb'?" if the directory of a missing file has a similar name, else a general
/// advice.
[[nodiscard]] std::string similar_file(const std::filesystem::path& file);

/// A path written in a scene file, made relative to the directory of the file that says it.
[[nodiscard]] std::filesystem::path beside(const std::filesystem::path& file,
                                           std::string_view written);

}  // namespace balcony::scene
