// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What is drawn on layers besides what cameras see.

#include "balcony/picture.hpp"
#include "camera/machine/arrange.hpp"

namespace balcony::camera {

/// A ramp from 0 to 1, one pixel wide, centred where a distance in pixels is 0.
[[nodiscard]] Expr antialiased(Expr distance, const Emitter& emit);

/// Converts a distance in the layer's image to pixels of the whole picture: to first order, the
/// distance divided by the length of its gradient. Without a gradient it is unchanged.
[[nodiscard]] Expr in_device_pixels(Expr distance, const PicturePoint& layer, Emitter& emit);

[[nodiscard]] PictureExpressions::Element painted(Expr coverage, const Stroke& stroke,
                                                  const Emitter& emit);

/// The distance of a point from the segment between two others.
[[nodiscard]] Expr segment_distance(const DevicePoint& p, const DevicePoint& a,
                                    const DevicePoint& b, const Emitter& emit);

/// A bar on a picture whose width in scene units is known.
[[nodiscard]] PictureExpressions::Element scale_bar(const ScaleBar& bar, double width,
                                                    const PicturePoint& picture, Emitter& emit);

}  // namespace balcony::camera
