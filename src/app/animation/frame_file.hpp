// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "balcony/base.hpp"

namespace balcony::app {

/// How much of a frame's file is read: all of it, or its end alone, where it shows fast that a file
/// is truncated.
enum class FramePart : std::uint8_t { all, end };

/// Why the picture in a file cannot be read to its end; nothing if it can.
[[nodiscard]] std::optional<Diagnostic> why_damaged(const std::filesystem::path& frame,
                                                    FramePart part);

}  // namespace balcony::app
