// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A picture divided into patches in which the ray is nearly a linear function of the position.

#include <vector>

#include "analyse/inverse/point_rays.hpp"
#include "rays/approach.hpp"

namespace balcony::analyse {

using rays::Approach;

/// A rectangle of the picture with the ray at its centre.
struct RayPatch {
    /// Bounds and starting points extend a quarter of a patch beyond it, in half sizes, because a
    /// seam next to it may hide a strip of a neighbour from that neighbour's centre.
    static constexpr double reach = 1.25;

    V2d center;
    V2d half;  ///< Half its size, in pixels.
    Ray ray;
    /// The estimated maximum deviation of origins and unit directions in the patch from
    /// the prediction by the derivatives at its centre.
    double origin_bend = 0.0;
    double direction_bend = 0.0;

    /// How far origins move along the central ray, times the change of directions:
    /// the error of a point whose distance is measured from the centre.
    double shear = 0.0;

    /// The maximum deviation of the point at a distance along the ray from the prediction.
    [[nodiscard]] double bend(double distance) const {
        return origin_bend + std::abs(distance) * direction_bend + shear;
    }
};

/// Rays all over the picture, or all over the part of it that has any, 9 in each cell of a grid:
/// the initial sampling of a camera.
struct Survey {
    struct Cell {
        V2d center;
        V2d half;
    };
    static constexpr std::size_t places = 9;

    std::vector<Cell> cells;
    std::vector<Ray> rays;  ///< By cell, then row by row; the fifth is the cell's centre.
    double extent = 0.0;    ///< The approximate radius of a ball around all origins.

    [[nodiscard]] bool any_ray() const;
    /// The picture position of the ray with an index.
    [[nodiscard]] V2d place(std::size_t index) const;
};

[[nodiscard]] Survey survey(const PointRays& rays, const V2d& picture, const Work& work);

struct Division {
    std::vector<RayPatch> patches;
    bool complete = true;  ///< No patch is larger than it should be.
};

/// Divides the cells of a survey until Newton's iteration contracts from the centre of each patch
/// to all points that the patch sees, or the patch is 1/16 pixel wide. The division is incomplete
/// if that would take more than some hundred thousand patches or some billion instructions. Parts
/// without rays are omitted.
[[nodiscard]] Division divide(const PointRays& rays, Survey survey, const Work& work);

}  // namespace balcony::analyse
