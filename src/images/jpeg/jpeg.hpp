// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// JPEG by libjpeg-turbo itself, since most photos are JPEG files and OpenImageIO takes 0.2 s to
// load.

#include <string_view>

#include "balcony/images.hpp"
#include "images/encoded_bytes.hpp"

namespace balcony::images {

/// Whether a file of these first bytes is one.
[[nodiscard]] bool is_jpeg(std::string_view start);
/// ImageFile::open() of a whole file that is one.
[[nodiscard]] Result<std::unique_ptr<ImageFile>> open_jpeg(EncodedBytes bytes);
/// encode() for "jpeg", of a raster with three channels of 8 bits.
[[nodiscard]] Result<std::vector<std::uint8_t>> encode_jpeg(const Raster& raster);

}  // namespace balcony::images
