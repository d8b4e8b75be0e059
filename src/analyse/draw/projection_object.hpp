// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A projection object, traced along lines of the picture.

#include <array>
#include <optional>
#include <vector>

#include <Imath/ImathBox.h>
#include <Imath/ImathVec.h>

#include "analyse/measure/work.hpp"
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

/// The maximum coordinate of what is shown, in scene units: squares of coordinates overflow single
/// precision, in which scenes are traced, not far beyond.
inline constexpr double max_coordinate = 1e18;

[[nodiscard]] bool is_near(const V3d& point);

/// What a drawing omits of an object.
struct Omissions {
    bool winding = false;  ///< Lines that turn or jump too often to be traced.
    bool far = false;      ///< Points beyond max_coordinate.
};

/// Maps points of the picture, as fractions of its width and height from the top left, to points of
/// the object. Belongs to one thread. All that computes points throws if the work is to stop.
class ProjectionObject {
public:
    /// `share` is the object's fraction of the maximum cost of a drawing.
    ProjectionObject(const camera::Path& path, double aspect, Axes axes, double time,
                     double share = 1.0, const Work& work = {});

    /// 0 for a point, 1 for a curve, 2 for a surface.
    [[nodiscard]] int dimension() const { return dimension_; }
    /// The bounds of a grid of its points; empty if none of these is defined.
    [[nodiscard]] const Box3d& bounds() const { return bounds_; }

    [[nodiscard]] std::optional<ProjectionObjectPoint> at(const V2d& picture);

    /// The image of the straight line of the picture from a to b, in pieces: it is interrupted
    /// where the object is undefined and where it jumps. Each piece is within the tolerance.
    /// Nothing if that takes more points than a line may have, or than remain for the object.
    [[nodiscard]] std::optional<std::vector<Polyline>> trace(const V2d& a, const V2d& b,
                                                             double tolerance);

    /// Whether the image of the line from a to b is uninterrupted.
    [[nodiscard]] bool joined(const V2d& a, const V2d& b);

    /// What has been omitted so far.
    [[nodiscard]] const Omissions& omissions() const { return omissions_; }

private:
    class Tracer;
    [[nodiscard]] Box3d measure();

    int dimension_;
    Axes axes_;
    double aspect_;
    double time_;
    Work work_;
    program::Program program_;
    program::Scratch scratch_;
    Omissions omissions_;
    std::size_t points_left_;  ///< For lines.
    Box3d bounds_;
};

}  // namespace balcony::analyse
