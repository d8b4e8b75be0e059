// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Builds a mesh out of several simple shapes.

#include <array>
#include <vector>

#include "balcony/scene.hpp"

namespace balcony::plates {

using Imath::M44d;
using Imath::V2d;
using Imath::V3d;

/// Collects faces. Texture coordinates are scene units: seen from outside, u to the right and v
/// down, on the coordinate plane that a face is nearest to. Round shapes have smooth normals.
class MeshBuilder {
public:
    /// Corners counter-clockwise, seen from outside.
    MeshBuilder& quad(const V3d& a, const V3d& b, const V3d& c, const V3d& d);
    MeshBuilder& triangle(const V3d& a, const V3d& b, const V3d& c) { return quad(a, b, c, c); }

    /// Its edges are cut off at 45 degrees by the chamfer.
    MeshBuilder& box(const V3d& low, const V3d& high, double chamfer = 0.0);

    /// The surface of revolution of points (radius, height) about the vertical through `foot`,
    /// listed upwards; from above, its outside is where the radii point. Ends are open. Where a
    /// point is repeated, the profile has an edge.
    MeshBuilder& lathe(const V3d& foot, const std::vector<V2d>& profile, int segments = 24);

    /// A tube with a round cross-section along points, closed at both ends by half spheres.
    struct Bead {
        V3d at;
        double radius;
    };
    MeshBuilder& tube(const std::vector<Bead>& beads, int segments = 12);

    /// Between two lines of points (x, z) with ascending x, from the front at y = from to the back
    /// at y = to > from: an arch, a gable, a moulding. Both lines have the same number of points.
    MeshBuilder& band(const std::vector<V2d>& lower, const std::vector<V2d>& upper, double from,
                      double to);

    MeshBuilder& ellipsoid(const V3d& middle, const V3d& radii, int segments = 24);

    /// Everything in `other`, placed.
    MeshBuilder& add(const MeshBuilder& other, const M44d& placed = M44d());

    [[nodiscard]] scene::Mesh mesh() const;

private:
    struct Corner {
        V3d position;
        V3d normal;
    };
    using Face = std::array<Corner, 4>;

    /// Rows of corners from below to above, each counter-clockwise about the vertical.
    MeshBuilder& grid(const std::vector<std::vector<Corner>>& rows);

    std::vector<Face> faces_;
};

}  // namespace balcony::plates
