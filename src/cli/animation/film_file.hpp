// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A film from pictures, by the program ffmpeg.

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "balcony/base.hpp"

namespace balcony::cli {

struct FilmRequest {
    std::filesystem::path file;
    std::string fps;              ///< A number or a fraction, such as 30000/1001.
    std::optional<double> crf{};  ///< The constant rate factor of the encoder: less is better.
};

/// Whether the name of a file has the extension of a film.
[[nodiscard]] bool is_film(const std::filesystem::path& file);
/// These extensions: ".mp4", ...
[[nodiscard]] std::vector<std::string> film_extensions();
/// Whether such a film has no sides of an odd number of pixels.
[[nodiscard]] bool has_even_sides(const std::filesystem::path& film);

/// Why a film could not be made: ffmpeg or its encoder is missing, the place cannot be written to,
/// or the factor is out of range.
[[nodiscard]] Diagnostics check_film(const FilmRequest& film);

/// Makes a film of pictures of one size. An existing film is replaced when the new one is complete.
/// `progress` is called before each picture with its index.
[[nodiscard]] Diagnostics write_film(const FilmRequest& film,
                                     std::span<const std::filesystem::path> pictures,
                                     const std::function<void(std::size_t)>& progress = {},
                                     const std::stop_token& stop = {});

}  // namespace balcony::cli
