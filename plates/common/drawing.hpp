// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Drawings of filled outlines, for textures that are painted with shapes rather than by a formula.

#include <functional>
#include <span>
#include <vector>

#include "common/painting.hpp"

namespace balcony::plates {

/// A line of points; y is up.
using Path = std::vector<V2d>;

/// A smooth line through points (centripetal Catmull-Rom), as short straight pieces.
[[nodiscard]] Path smooth_path(std::span<const V2d> points);

/// The same, closed.
[[nodiscard]] Path smooth_outline(std::span<const V2d> points);

/// The outline of what a round brush leaves along a path; half_width is a function of the part of
/// the path's length, 0 to 1.
[[nodiscard]] Path brush_stroke(const Path& path, const std::function<double(double)>& half_width);

/// The same with one width.
[[nodiscard]] Path line(const Path& path, double width);

[[nodiscard]] Path ellipse(const V2d& center, const V2d& radii);

/// Along a circle, from one angle to another, in radians counterclockwise from x.
[[nodiscard]] Path arc(const V2d& center, double radius, double from, double to);

/// Places a shape: scaled (a negative factor mirrors it), then rotated counterclockwise, then
/// moved.
struct Placement {
    V2d scale{1.0, 1.0};
    double angle = 0.0;  ///< Radians.
    V2d offset{0.0, 0.0};
};
[[nodiscard]] Path placed(Path path, const Placement& placement);

/// A picture that goes round: what crosses its right edge goes on at the left.
class Drawing {
public:
    /// `length` is the length of the way round and `height` that of the picture, in units of the
    /// outlines, whose origin is at the bottom left. Pixels are square.
    Drawing(int pixels_round, double length, double height, const Color& ground);

    /// Fills an outline, antialiased; where it crosses itself, all of its inside.
    void fill(const Path& outline, const Color& color);

    [[nodiscard]] double length() const { return length_; }
    [[nodiscard]] double height() const { return height_; }

    /// The colour at a place; beyond the picture's height, that of its edge.
    [[nodiscard]] Color at(const V2d& place) const;

private:
    void fill_row(const Path& outline, int row, const Color& color);

    double length_, height_;
    int columns_, rows_;
    double pixels_per_unit_;
    std::vector<Color> pixels_;  // Rows from the top.
};

}  // namespace balcony::plates
