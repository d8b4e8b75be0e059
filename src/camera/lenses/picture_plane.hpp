// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/stages.hpp"

namespace balcony::camera {

/// A vector below this square of its length has no direction.
inline constexpr double smallest_square = 1e-24;

/// The plane on which a perspective camera projects, at the middle of the picture: unit vectors to
/// the right in it, and across it into the scene. Of another camera, of the perspective camera with
/// the same first and second derivatives there.
struct PicturePlane {
    ObjectVector right, normal;
};

/// The plane of the camera that a central ray belongs to; the same for all points of the picture.
[[nodiscard]] PicturePlane picture_plane(const CentralRay& ray, const Emitter& emit);

}  // namespace balcony::camera
