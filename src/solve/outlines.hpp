// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Outlines as the marks that are outermost in the picture. Which ones these are changes while the
// camera does, but where they are changes continuously.

#include <span>
#include <vector>

#include "balcony/solve.hpp"

namespace balcony::solve {

/// The problem with the points of its outlines as further marks, outline by outline, on which the
/// constraints about these are.
[[nodiscard]] Problem with_outline_marks(Problem problem);

/// Those of some positions that a constraint about an outline is about, as indices: the outermost
/// ones at the left, at the right, at the top and at the bottom or, of a line, those that are
/// farthest on either side.
[[nodiscard]] std::vector<std::size_t> outermost(const Constraint& constraint,
                                                 std::span<const V2d> at);

/// The distance of a position from a line, in pixels; positive on one side.
template <class Number>
[[nodiscard]] Number distance_from(const std::array<V2d, 2>& line, const Number& x,
                                   const Number& y) {
    const V2d along = (line[1] - line[0]).normalized();
    return (x - line[0].x) * along.y - (y - line[0].y) * along.x;
}

/// The corners of the smallest convex polygon around some positions.
[[nodiscard]] std::vector<V2d> hull_of(std::vector<V2d> at);

}  // namespace balcony::solve
