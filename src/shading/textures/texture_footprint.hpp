// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Imath/ImathVec.h>

namespace balcony::render {

/// The position of a texture look-up, and its change from one pixel to the next, in widths and
/// heights of the image.
struct TextureFootprint {
    Imath::V2f at;
    Imath::V2f along_x;
    Imath::V2f along_y;
};

}  // namespace balcony::render
