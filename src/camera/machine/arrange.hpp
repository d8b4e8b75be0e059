// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Applies picture arrangers to points of pictures.

#include <array>
#include <span>

#include "balcony/stages.hpp"

namespace balcony::camera {

/// Picture x and y in a picture of the given size in pixels.
[[nodiscard]] PicturePoint whole_picture(Graph& graph, double width, double height);

/// Maps a point of the whole picture to the image inside the arrangers, outermost first.
[[nodiscard]] PicturePoint arranged(PicturePoint whole,
                                    std::span<const PictureArrangerPointer> arrangers,
                                    Emitter& emit);

/// Width and height in pixels of the picture that the arrangers, outermost first, lead to.
[[nodiscard]] std::array<double, 2> arranged_size(std::span<const PictureArrangerPointer> arrangers,
                                                  double width, double height, double time);

/// Whether a point is in its picture, including the border.
[[nodiscard]] Expr inside(const PicturePoint& picture);

/// The point of the picture that is nearest.
[[nodiscard]] PicturePoint clamped(const PicturePoint& picture);

/// The position of a point of the arranged image, in fractions from its top left corner, in the
/// whole picture: inverts arrange() by Newton's method from the centre, which is exact if
/// the arrangers are affine.
[[nodiscard]] DevicePoint find_arranged(const PictureSize& whole,
                                        std::span<const PictureArrangerPointer> arrangers,
                                        const DevicePoint& fraction, Emitter& emit);

}  // namespace balcony::camera
