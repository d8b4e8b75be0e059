// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Image points: where a picture shows points in space. The renderer uses this interface, which
// analyse::Locator (inverse.hpp) implements.

#include <cstddef>
#include <span>

#include <Imath/ImathVec.h>

namespace balcony::rays {

using Imath::V2d;
using Imath::V3d;

/// A point in space, and the place in the picture near which it is expected.
struct ImagePointQuery {
    V3d point;
    std::size_t layer = 0;  ///< The camera layer of the picture, from 0 at the back.
    V2d expected;           ///< In pixels.
};

struct ImagePoint {
    std::size_t places = 0;  ///< The number of places at which the layer shows the point.
    V2d position;            ///< The one nearest to the expected place, in pixels; 0 without any.
};

/// The inverse of a picture at one time. Immutable, may be shared by threads.
class ImagePointFinder {
public:
    virtual ~ImagePointFinder() = default;

    /// Answers query i in found[i]. Hidden surfaces of a scene are not considered.
    virtual void find(std::span<const ImagePointQuery> queries,
                      std::span<ImagePoint> found) const = 0;
};

}  // namespace balcony::rays
