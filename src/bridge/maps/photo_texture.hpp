// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A photo as a texture of OpenImageIO.

#include <array>
#include <memory>

#include "balcony/st_maps.hpp"

namespace balcony::bridge {

/// Look-ups may come from any number of threads.
class PhotoTexture {
public:
    /// The photo must outlive it. A photo that closes goes on at its other side.
    PhotoTexture(const Photo& photo, bool closes);
    ~PhotoTexture();
    PhotoTexture(const PhotoTexture&) = delete;
    PhotoTexture& operator=(const PhotoTexture&) = delete;

    /// The mean over the part of the photo that a pixel shows: linear red, green, blue,
    /// premultiplied, and alpha.
    [[nodiscard]] std::array<float, 4> operator()(const SourcePlace& place) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace balcony::bridge
