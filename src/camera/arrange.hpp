// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Points of pictures on their way through picture arrangers.

#include <array>
#include <span>

#include "balcony/camera.hpp"

namespace balcony::camera {

/// Picture x and y in a picture of the given size in pixels.
[[nodiscard]] PicturePoint whole_picture(Graph& graph, double width, double height);

/// A point of the whole picture in the picture that the arrangers, outermost first, lead to.
[[nodiscard]] PicturePoint arranged(PicturePoint whole,
                                    std::span<const PictureArrangerPointer> arrangers,
                                    Emitter& emit);

/// Width and height in pixels of the picture that the arrangers, outermost first, lead to.
[[nodiscard]] std::array<double, 2> arranged_size(std::span<const PictureArrangerPointer> arrangers,
                                                  double width, double height, double time);

/// Whether a point lies in its picture, the border included.
[[nodiscard]] Expr inside(const PicturePoint& picture);

/// The point of the picture that is nearest.
[[nodiscard]] PicturePoint clamped(const PicturePoint& picture);

/// Where a point of the arranged picture, in fractions of it from its top left corner, lies in the
/// whole: arrange() inverted by Newton's method from the middle of the whole, which is exact where
/// the arrangers are affine.
[[nodiscard]] DevicePoint find_arranged(const PictureSize& whole,
                                        std::span<const PictureArrangerPointer> arrangers,
                                        const DevicePoint& fraction, Emitter& emit);

}  // namespace balcony::camera
