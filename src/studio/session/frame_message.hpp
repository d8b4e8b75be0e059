// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "balcony/live.hpp"
#include "balcony/thumbnails.hpp"

namespace balcony::studio {

// Pictures as the bytes of a message: the length of its head, the head as JSON, and the picture.

/// A frame in motion is a JPEG file, others are PNG files.
[[nodiscard]] std::vector<std::uint8_t> frame_message(const live::Frame& frame);
/// A JPEG file.
[[nodiscard]] std::vector<std::uint8_t> thumbnail_message(const live::Thumbnail& thumbnail);

}  // namespace balcony::studio
