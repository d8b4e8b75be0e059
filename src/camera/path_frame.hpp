// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "balcony/camera.hpp"
#include "camera/curve_sampler.hpp"

namespace balcony::camera {

/// The upward vectors of a frame that goes along a path without turning about the tangent, as
/// tables over the part of the way in the path's parameter, from 0 to 1.
struct PathFrame {
    std::array<std::shared_ptr<const expr::Table>, 3> up;
    bool closed = false;  ///< The path comes back, and the frame with it.
};

/// Samples the path between two of its parameters. The frame begins with the part of `up` across
/// the path. If the path comes back, the angle by which the frame would not is taken off evenly on
/// the way.
[[nodiscard]] Result<PathFrame> rotation_minimising_frame(const ObjectGenerator& path, double from,
                                                          double to, const Vector3& up);

}  // namespace balcony::camera
