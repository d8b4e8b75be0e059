// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A projection object, traced along lines of the picture.

#include <array>
#include <optional>
#include <vector>

#include <Imath/ImathBox.h>
#include <Imath/ImathVec.h>

#include "balcony/camera.hpp"
#include "balcony/program.hpp"

namespace balcony::analyse {

using Imath::Box3d;
using Imath::V2d;
using Imath::V3d;

using Polyline = std::vector<V3d>;

/// A point of the object, with z up.
struct ProjectionObjectPoint {
    V3d position;
    V3d normal;      ///< Unit length; 0 where there is none.
    V2d parameters;  ///< (u, v)
};

/// Maps points of the picture, as fractions of its width and height from the top left, to points of
/// the object. Belongs to one thread.
class ProjectionObject {
public:
    ProjectionObject(const camera::Path& path, double aspect, Axes axes, double time);

    /// 0 for a point, 1 for a curve, 2 for a surface.
    [[nodiscard]] int dimension() const { return dimension_; }
    /// The bounds of a grid of its points; empty if none of these is defined.
    [[nodiscard]] const Box3d& bounds() const { return bounds_; }

    [[nodiscard]] std::optional<ProjectionObjectPoint> at(const V2d& picture);

    /// The image of the straight line of the picture from a to b, in pieces: it is interrupted
    /// where the object is undefined and where it jumps. Each piece is within the tolerance.
    [[nodiscard]] std::vector<Polyline> trace(const V2d& a, const V2d& b, double tolerance);

    /// Whether the image of the line from a to b is uninterrupted.
    [[nodiscard]] bool joined(const V2d& a, const V2d& b);

private:
    class Tracer;
    [[nodiscard]] Box3d measure();

    int dimension_;
    Axes axes_;
    double aspect_;
    double time_;
    program::Program program_;
    program::Scratch scratch_;
    Box3d bounds_;
};

}  // namespace balcony::analyse
