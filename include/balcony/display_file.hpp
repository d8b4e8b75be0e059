// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Files for display: PNG, JPEG, WebP and TIFF of sRGB samples.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"

namespace balcony::render {

struct DisplayFormat {
    std::string_view extension;  ///< ".png"
    std::string_view encoder;    ///< The format, as for images::encode().
    bool has_alpha = true;
    int bits = 8;  ///< Bits per channel by default.
    int max_bits = 8;
    std::size_t max_side = 0;    ///< In pixels.
    bool has_resolution = true;  ///< Whether a file says how large its pixels are in print.
};

[[nodiscard]] std::span<const DisplayFormat> display_formats();
/// The format of a file by its extension; null if it is none of these.
[[nodiscard]] const DisplayFormat* display_format(const std::filesystem::path& file);

/// Samples by rows from the top, then columns, then channels.
struct DisplaySize {
    std::size_t width = 0;
    std::size_t height = 0;
    std::size_t channels = 0;  ///< 3, or 4 with straight alpha, which the format must have.
    double dpi = 0.0;          ///< As images::Raster::dpi; of no effect without a resolution.
};

/// An error if a picture is larger than the format allows.
[[nodiscard]] Diagnostics check_size(const DisplayFormat& format, std::size_t width,
                                     std::size_t height);

/// The bytes of a file.
[[nodiscard]] Result<std::vector<std::uint8_t>> encode(const std::vector<std::uint8_t>& samples,
                                                       const DisplaySize& size,
                                                       const DisplayFormat& format);
[[nodiscard]] Result<std::vector<std::uint8_t>> encode(const std::vector<std::uint16_t>& samples,
                                                       const DisplaySize& size,
                                                       const DisplayFormat& format);

/// Writes a file in the format of its extension. The file is complete or unchanged.
[[nodiscard]] Diagnostics write_samples(const std::vector<std::uint8_t>& samples,
                                        const DisplaySize& size, const std::filesystem::path& file);

}  // namespace balcony::render
