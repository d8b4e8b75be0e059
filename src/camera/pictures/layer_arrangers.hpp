// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The positions of a picture's layers as picture arrangers.

#include <vector>

#include "balcony/picture.hpp"

namespace balcony::camera {

struct LayerArrangers {
    std::vector<PictureArrangerPointer> window;   ///< From the whole picture to the layer's window.
    std::vector<PictureArrangerPointer> content;  ///< From the window to the layer's own picture.

    /// Both in sequence.
    [[nodiscard]] std::vector<PictureArrangerPointer> all() const;
};

[[nodiscard]] LayerArrangers arrangers_of(const Picture::Parts& parts, std::size_t layer);

/// From a whole of any aspect to the picture in it; null if the picture takes the whole, as one of
/// a single camera does, whose layer is fitted.
[[nodiscard]] PictureArrangerPointer fitting_of(const Picture& picture);

/// From a whole of any aspect to a picture of another one in its middle; not for Fit::stretch.
[[nodiscard]] PictureArrangerPointer fitting(Fit fit, double aspect);

/// The region of its own picture that a layer shows.
[[nodiscard]] PictureRegion shown_region(const Layer& layer);

}  // namespace balcony::camera
