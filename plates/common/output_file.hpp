// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "balcony/base.hpp"

namespace balcony::plates {

/// Writes a file whole or not at all: the bytes go to a file beside it that is then renamed. A
/// failure is returned, and leaves an older file of that name as it was.
[[nodiscard]] std::optional<Diagnostic> write_whole(const std::filesystem::path& file,
                                                    const std::vector<std::uint8_t>& bytes);

}  // namespace balcony::plates
