// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/textures/held_texture.hpp"

#include <new>

namespace balcony::render {

namespace {

struct Stopped {};

}  // namespace

// An exception leaves the texture as it was, to be decoded later.
void HeldTexture::decode(const std::stop_token& stop) const {
    try {
        std::call_once(once_, [&] { read(stop); });
    } catch (const Stopped&) {
    }
}

void HeldTexture::read(const std::stop_token& stop) const {
    try {
        Result<TextureReader> image = TextureReader::open(texture_, encoding_);
        if (image) {
            image->obey(stop);
        }
        Result<MipPyramid> made = image ? MipPyramid::read(*image, texture_, file_)
                                        : Result<MipPyramid>(image.diagnostics);
        if (made) {
            pyramid_.emplace(std::move(*made));
            repaired_ = image->has_repaired();
        } else if (kind_of_errors(made.diagnostics) == Kind::interrupted) {
            throw Stopped{};
        } else {
            failure_ = made.diagnostics.front();
        }
    } catch (const std::bad_alloc&) {
        failure_ = error("it needs more memory than available");
    }
    read_.store(true, std::memory_order_release);
}

}  // namespace balcony::render
