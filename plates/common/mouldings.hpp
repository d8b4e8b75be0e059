// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Mouldings, which a profile of lines and arcs sweeps, and grids.

#include <numbers>
#include <vector>

#include "balcony/scene.hpp"
#include "common/painting.hpp"

namespace balcony::plates {

/// A profile in the plane of the distance r from the z axis (x) and the height z (y). It runs
/// counter-clockwise round what is solid: up along an outer side. Each run is smooth; where one run
/// ends and the next one begins is an edge.
class Profile {
public:
    explicit Profile(const V2d& start) : at_(start) {}

    Profile& line(const V2d& to);
    /// A circular arc that bulges to the right of the way (outwards, on an outer side) by a
    /// fraction of the length of its chord: 0.5 is a half circle, negative is hollow.
    Profile& arc(const V2d& to, double bulge, int pieces = 6);

    using Run = std::vector<V2d>;
    [[nodiscard]] const std::vector<Run>& runs() const { return runs_; }

private:
    V2d at_;
    std::vector<Run> runs_;
};

/// A range of angles round the z axis, in radians.
struct Turn {
    double from = 0.0;
    double to = 2.0 * std::numbers::pi;
};

/// The surface that a profile sweeps, in so many segments. Texture coordinates are lengths along
/// the surface, divided by texture_size.
[[nodiscard]] scene::Mesh revolve(const Profile& profile, int segments, const Turn& turn = {},
                                  double texture_size = 1.0);

/// A grid of columns x rows vertices, row by row, with normals from its neighbours. The front is
/// where columns run to the right and rows upwards.
[[nodiscard]] scene::Mesh grid(std::uint32_t columns, const std::vector<V3d>& points,
                               double texture_size = 1.0);

/// A flat polygon, counter-clockwise seen from its front, all of whose corners its middle sees.
[[nodiscard]] scene::Mesh fan(const std::vector<V3d>& outline, double texture_size = 1.0);

/// Gives all vertices one colour, which multiplies that of the material.
void set_color(scene::Mesh& mesh, const Color& color);

/// A mesh whose positions and normals are moved by a rigid motion.
[[nodiscard]] scene::Mesh moved(scene::Mesh mesh, const scene::M44d& motion);

}  // namespace balcony::plates
