// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/textures/held_texture.hpp"

#include <new>

namespace balcony::render {

void HeldTexture::read() const {
    try {
        Result<TextureReader> image = TextureReader::open(texture_, encoding_);
        Result<MipPyramid> made = image ? MipPyramid::read(*image, texture_, file_)
                                        : Result<MipPyramid>(image.diagnostics);
        if (made) {
            pyramid_.emplace(std::move(*made));
            repaired_ = image->has_repaired();
        } else {
            failure_ = made.diagnostics.front();
        }
    } catch (const std::bad_alloc&) {
        failure_ = error("it needs more memory than available");
    }
    read_.store(true, std::memory_order_release);
}

}  // namespace balcony::render
