// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// PNG by libpng itself, since most pictures are PNG files and OpenImageIO takes 0.2 s to load.

#include <string_view>

#include "balcony/images.hpp"
#include "images/encoded_bytes.hpp"

namespace balcony::images {

/// Whether a file of these first bytes is one.
[[nodiscard]] bool is_png(std::string_view start);
/// ImageFile::open() of a whole file that is one.
[[nodiscard]] Result<std::unique_ptr<ImageFile>> open_png(EncodedBytes bytes);
/// encode() for "png".
[[nodiscard]] Result<std::vector<std::uint8_t>> encode_png(const Raster& raster);

}  // namespace balcony::images
