// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "balcony/stereo.hpp"
#include "cli/command_line.hpp"

namespace balcony::cli {

/// The words of --stereo and what belongs to it; empty words are not given.
struct StereoWords {
    std::string format;
    std::string separation;
    std::string convergence;
    std::string baseline;
    std::string merge;
};

/// A stereo picture, or the pictures of both eyes in two files.
struct StereoRequest {
    std::vector<camera::StereoFormat> formats;  ///< One, or left and right.
    camera::StereoPair pair;

    [[nodiscard]] bool has_two_files() const { return formats.size() > 1; }
    /// Whether the eyes differ in their colours alone.
    [[nodiscard]] bool is_anaglyph() const;
};

void add_stereo_options(CLI::App& command, StereoWords& words);

/// Nothing without --stereo. What cannot be read is added to `diagnostics`.
[[nodiscard]] std::optional<StereoRequest> read_stereo(const StereoWords& words,
                                                       Diagnostics& diagnostics);

/// The file of an eye's picture: film.left.png for film.png.
[[nodiscard]] std::filesystem::path file_of_eye(const std::filesystem::path& file,
                                                camera::StereoFormat eye);

}  // namespace balcony::cli
