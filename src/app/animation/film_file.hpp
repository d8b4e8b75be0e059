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

#include "balcony/animation.hpp"

namespace balcony::app {

/// Whether such a film has no sides of an odd number of pixels.
[[nodiscard]] bool has_even_sides(const std::filesystem::path& film);

/// Why a film could not be made: ffmpeg or its encoder is missing, the place cannot be written to,
/// or the factor is out of range (an error of usage).
[[nodiscard]] Diagnostics check_film(const FilmRequest& film);

/// Makes a film of pictures of one size. An existing film is replaced when the new one is complete.
/// `progress` is called before each picture with its index.
[[nodiscard]] Diagnostics write_film(const FilmRequest& film,
                                     std::span<const std::filesystem::path> pictures,
                                     const std::function<void(std::size_t)>& progress = {},
                                     const std::stop_token& stop = {});

}  // namespace balcony::app
