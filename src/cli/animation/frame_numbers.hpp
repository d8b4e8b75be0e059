// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The numbers of the frames of an animation.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace balcony::cli {

/// In increasing order, each once.
using FrameNumbers = std::vector<std::size_t>;

inline constexpr std::size_t max_frame = 9'999'999;

/// "1-240", "7", "1-240x10" (every tenth), or several of these with commas between them, as other
/// programs and render farms write them; nothing if the text is none of these.
[[nodiscard]] std::optional<FrameNumbers> frame_numbers_of(std::string_view text);

/// The shortest such text: "1-4,7".
[[nodiscard]] std::string text_of(std::span<const std::size_t> frames);

}  // namespace balcony::cli
