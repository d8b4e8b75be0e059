// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "balcony/stages.hpp"
#include "camera/curves/curve_sampler.hpp"
#include "camera/curves/spline_tables.hpp"
#include "camera/tables/cell_position.hpp"

namespace balcony::camera {

/// A point of a path with its derivatives by the path's parameter.
struct PathPlace {
    ObjectPoint point;
    ObjectVector along;
    ObjectVector along_by_parameter;  ///< The second derivative.
};

/// There is no ray where the path has no point.
[[nodiscard]] PathPlace place_on(const ObjectGenerator& path, Expr parameter, Emitter& emit);

/// The upward vectors of a frame that goes along a path without turning about the tangent, as
/// tables over cells, and where a part of the way in the path's parameter, from 0 to 1, lies among
/// these.
struct PathFrame {
    std::array<TablePointer, 3> up;
    std::optional<CellPosition> position;
    bool closed = false;  ///< The path comes back, and the frame with it.
};

/// Samples the path between two of its parameters. The frame begins with the part of `up` across
/// the path. If the path comes back, the angle by which the frame would not is taken off evenly on
/// the way.
///
/// Steps are double reflections (Wang, Jüttler, Zheng and Liu, "Computation of Rotation Minimizing
/// Frames", 2008), so many that the frame is off by at most some 1e-6 radians. The estimate of that
/// error is the difference between one step and two; cells in which the path's second derivative
/// jumps are halved until it is as small, or until the cell is 1/16384 of the way.
[[nodiscard]] Result<PathFrame> rotation_minimising_frame(const ObjectGenerator& path, double from,
                                                          double to, const Vector3& up);

}  // namespace balcony::camera
