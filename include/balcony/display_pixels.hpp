// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Display pixels: a film as a window shows it, without a file.

#include <cstdint>
#include <vector>

#include "balcony/film.hpp"

namespace balcony::render {

/// sRGB samples of 8 bits of the film's window, by rows from the top, then columns, then red,
/// green and blue: what encode() puts into a format without alpha. DisplayOptions::bits and dpi
/// have no effect. Empty for a film whose vectors do not have the size of its window.
[[nodiscard]] std::vector<std::uint8_t> display_pixels(const Film& film,
                                                       const DisplayOptions& options = {});

}  // namespace balcony::render
