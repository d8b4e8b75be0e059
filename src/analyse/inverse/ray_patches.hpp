// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A picture divided into patches over which the ray is nearly a linear function of the place.

#include <vector>

#include "analyse/inverse/approach.hpp"
#include "analyse/inverse/point_rays.hpp"

namespace balcony::analyse {

/// A rectangle of the picture with the ray in its middle.
struct RayPatch {
    V2d center;
    V2d half;  ///< Half its size, in pixels.
    Ray ray;
    /// By how much, at most and estimated, origins and unit directions in the patch depart from
    /// what the derivatives in its middle say.
    double origin_bend = 0.0;
    double direction_bend = 0.0;

    /// By how much origins move along the ray of the middle, times by how much directions change:
    /// what a point loses whose distance is measured from the middle.
    double shear = 0.0;

    /// How far the place at a distance along the ray may be from where the derivatives put it.
    [[nodiscard]] double bend(double distance) const {
        return origin_bend + std::abs(distance) * direction_bend + shear;
    }
};

/// Rays all over the picture, or all over the part of it that has any, 9 in each cell of a grid:
/// the first look at a camera.
struct Survey {
    struct Cell {
        V2d center;
        V2d half;
    };
    static constexpr std::size_t places = 9;

    std::vector<Cell> cells;
    std::vector<Ray> rays;  ///< Those of a cell together, row by row, its middle the fifth.
    double extent = 0.0;    ///< The radius of a ball around all origins, about.

    [[nodiscard]] bool any_ray() const;
    /// Where the ray of an index comes from.
    [[nodiscard]] V2d place(std::size_t index) const;
};

[[nodiscard]] Survey survey(const PointRays& rays, const V2d& picture);

/// Divides the cells of a survey until Newton's iteration contracts from the middle of each patch
/// towards all that the patch sees, or the patch is 1/16 pixel wide, or there are some hundred
/// thousand of them. Parts without rays are left out.
[[nodiscard]] std::vector<RayPatch> divide(const PointRays& rays, Survey survey);

}  // namespace balcony::analyse
