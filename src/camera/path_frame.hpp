// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "balcony/camera.hpp"
#include "camera/curve_sampler.hpp"

namespace balcony::camera {

/// The upward vectors of a frame that moves along a path without rotating about the tangent, as
/// tables over the fraction of the path's parameter range, from 0 to 1.
struct PathFrame {
    std::array<std::shared_ptr<const expr::Table>, 3> up;
    bool closed = false;  ///< The path is closed, and so is the frame.
};

/// Samples the path between two of its parameters. The frame starts with the component of `up`
/// perpendicular to the path. If the path is closed, the angle between its first and last frame is
/// distributed evenly.
[[nodiscard]] Result<PathFrame> rotation_minimising_frame(const ObjectGenerator& path, double from,
                                                          double to, const Vector3& up);

}  // namespace balcony::camera
