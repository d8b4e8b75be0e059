// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Newton's iteration from many starts at once.

#include <vector>

#include "analyse/inverse/point_rays.hpp"
#include "analyse/inverse/ray_patches.hpp"
#include "balcony/inverse.hpp"

namespace balcony::analyse {

/// A start of the iteration: a point to be found in one patch.
struct SearchStart {
    std::size_t number = 0;  ///< Of the point.
    V3d point;
    V2d center, half;  ///< Of the patch.
    V2d from;          ///< A known position, and by how much its ray misses the point.
    double miss;
    V2d step;  ///< The step from there to the starting position.
};

/// The starts that find all sightings of a point in a patch; none if it has none.
void add_starts(const RayPatch& patch, std::size_t number, const V3d& point,
                std::vector<SearchStart>& starts);

/// Runs iterations from starts. Belongs to one thread.
class PointSearch {
public:
    PointSearch(const PointRays& rays, const Work& work) : batch_(rays, work) {}

    /// Appends the sightings, unsorted and with duplicates.
    void run(const std::vector<SearchStart>& starts, std::vector<Sighting>& found);

private:
    PointRays::Batch batch_;
};

/// Whether a ray at a picture position passes through a point, within rounding.
[[nodiscard]] bool meets(const Ray& ray, const Approach& approach, const V3d& point);

/// The sighting for a ray that passes through the point with a number.
[[nodiscard]] Sighting sighting_of(std::size_t point, const V2d& place, const Ray& ray,
                                   const Approach& approach);

}  // namespace balcony::analyse
