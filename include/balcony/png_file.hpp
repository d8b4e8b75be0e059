// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Writes sRGB samples as a PNG file.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "balcony/base.hpp"

namespace balcony::render {

struct PngSize {
    std::size_t width = 0;
    std::size_t height = 0;
    std::size_t channels = 0;  ///< 3, or 4 with straight alpha.
};

/// Samples by rows from the top, then columns, then channels. The file is complete or unchanged.
[[nodiscard]] Diagnostics write_png(const std::vector<std::uint8_t>& samples, const PngSize& size,
                                    const std::filesystem::path& file);
[[nodiscard]] Diagnostics write_png(const std::vector<std::uint16_t>& samples, const PngSize& size,
                                    const std::filesystem::path& file);

}  // namespace balcony::render
