// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/images.hpp"

namespace balcony::images {

/// encode() for "png".
[[nodiscard]] Result<std::vector<std::uint8_t>> encode_png(const Raster& raster);

}  // namespace balcony::images
