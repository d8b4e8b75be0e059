// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "balcony/base.hpp"

namespace balcony::lang {

inline constexpr std::size_t max_file = 1'000'000;

/// Why a file with such a name is no camera file, and how it serves a camera: a scene, a
/// calibration or a picture.
[[nodiscard]] std::optional<Diagnostic> not_a_camera_file(const std::filesystem::path& file,
                                                          const std::string& name);

/// Reads a camera file of at most `max_file` bytes. `asked` is where the file is named.
[[nodiscard]] Result<std::shared_ptr<const SourceText>> read_source(
    const std::filesystem::path& file, const std::string& name, const SourceSpan& asked);

}  // namespace balcony::lang
