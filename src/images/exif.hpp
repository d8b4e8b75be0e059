// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace balcony::images {

/// The orientation in EXIF data, which begin with the header of TIFF (EXIF 2.3, section 4.6.4); 1,
/// as stored, if they have none.
[[nodiscard]] int exif_orientation(std::string_view exif);

}  // namespace balcony::images
