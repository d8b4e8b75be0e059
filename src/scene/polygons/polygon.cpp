// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/polygons/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Imath/ImathBox.h>

namespace balcony::scene {

namespace {

using Imath::V2d;

// Newell's method: the sum of the cross products of successive corners.
V3d area_normal(std::span<const V3f> corners) {
    const V3d origin(corners.front());
    V3d sum(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        sum += (V3d(corners[i]) - origin).cross(V3d(corners[i + 1]) - origin);
    }
    return sum;
}

// The corners without the coordinate along which the normal is longest, counter-clockwise.
std::vector<V2d> flattened(std::span<const V3f> corners) {
    const V3d normal = area_normal(corners);
    const V3d size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const double sign = normal[axis] < 0.0 ? -1.0 : 1.0;
    std::vector<V2d> flat;
    flat.reserve(corners.size());
    for (const V3f& corner : corners) {
        flat.emplace_back(sign * double{corner[(axis + 1) % 3]}, double{corner[(axis + 2) % 3]});
    }
    return flat;
}

// Positive if the path from a by b to c turns left.
double turn(const V2d& a, const V2d& b, const V2d& c) { return (b - a).cross(c - b); }

// Points by the cells of a grid, so that those in a small box are found among few.
class PointGrid {
public:
    PointGrid(const std::vector<V2d>& points, const std::vector<std::uint32_t>& chosen) {
        for (const std::uint32_t i : chosen) {
            box_.extendBy(points[i]);
        }
        const double count = std::sqrt(static_cast<double>(chosen.size()));
        side_ = std::max<std::size_t>(1, static_cast<std::size_t>(count));
        cells_.resize(side_ * side_);
        for (const std::uint32_t i : chosen) {
            cells_[cell_of(points[i].y, 1) * side_ + cell_of(points[i].x, 0)].push_back(i);
        }
    }

    /// Whether the predicate holds for a point of the cells that a box touches.
    template <class Predicate>
    [[nodiscard]] bool any_of(const Imath::Box2d& box, const Predicate& predicate) const {
        for (std::size_t y = cell_of(box.min.y, 1); y <= cell_of(box.max.y, 1); ++y) {
            for (std::size_t x = cell_of(box.min.x, 0); x <= cell_of(box.max.x, 0); ++x) {
                const std::vector<std::uint32_t>& cell = cells_[y * side_ + x];
                if (std::any_of(cell.begin(), cell.end(), predicate)) {
                    return true;
                }
            }
        }
        return false;
    }

private:
    // Grows with the coordinate, also beyond the points.
    [[nodiscard]] std::size_t cell_of(double coordinate, int axis) const {
        const double part =
            (coordinate - box_.min[axis]) / std::max(box_.max[axis] - box_.min[axis], 1e-300);
        const auto count = static_cast<double>(side_);
        return static_cast<std::size_t>(std::clamp(part * count, 0.0, count - 1.0));
    }

    Imath::Box2d box_;
    std::size_t side_ = 1;
    std::vector<std::vector<std::uint32_t>> cells_;
};

// The polygon as it is left: a ring of corners.
class Ring {
public:
    explicit Ring(std::span<const V3f> corners) : points_(flattened(corners)) {
        const auto count = static_cast<std::uint32_t>(points_.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            links_.push_back({(i + count - 1) % count, (i + 1) % count});
        }
        is_reflex_.resize(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            if (turn_at(i) < 0.0) {
                is_reflex_[i] = true;
                reflex_.push_back(i);
            }
        }
        constexpr std::size_t most_of_a_corner = 2048;
        tests_left_ = points_.size() * std::min(4 * points_.size(), most_of_a_corner);
    }

    [[nodiscard]] bool is_convex() const { return reflex_.empty(); }

    void clip_ears(std::vector<std::array<std::uint32_t, 3>>& triangles) {
        grid_.emplace(points_, reflex_);
        std::uint32_t at = 0;
        for (std::size_t left = points_.size(); left > 2; --left) {
            // If no corner is an ear, the polygon intersects itself, and any corner is cut off.
            for (std::size_t tried = 0; tried < left && !is_ear(at); ++tried) {
                at = links_[at].next;
            }
            const std::uint32_t before = links_[at].before;
            const std::uint32_t after = links_[at].next;
            triangles.push_back({before, at, after});
            links_[before].next = after;
            links_[after].before = before;
            is_reflex_[at] = false;
            is_reflex_[before] = is_reflex_[before] && turn_at(before) < 0.0;
            is_reflex_[after] = is_reflex_[after] && turn_at(after) < 0.0;
            // Skipping a corner avoids long thin triangles about one corner.
            at = links_[after].next;
        }
    }

private:
    struct Links {
        std::uint32_t before;
        std::uint32_t next;
    };

    [[nodiscard]] double turn_at(std::uint32_t corner) const {
        return turn(points_[links_[corner].before], points_[corner], points_[links_[corner].next]);
    }

    // Only a reflex corner can lie in the triangle of an ear. One without area has none, so that no
    // corner may lie on its line.
    [[nodiscard]] bool is_ear(std::uint32_t corner) {
        const double area = turn_at(corner);
        if (area < 0.0) {
            return false;
        }
        const V2d& a = points_[links_[corner].before];
        const V2d& b = points_[corner];
        const V2d& c = points_[links_[corner].next];
        const auto is_inside = [&](std::uint32_t other) {
            if (tests_left_ == 0 || !is_reflex_[other]) {
                return false;
            }
            --tests_left_;
            const V2d& p = points_[other];
            return p != a && p != b && p != c && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 &&
                   turn(c, a, p) >= 0.0;
        };
        if (area == 0.0) {
            return std::none_of(reflex_.begin(), reflex_.end(), is_inside);
        }
        Imath::Box2d box(a);
        box.extendBy(b);
        box.extendBy(c);
        return !grid_->any_of(box, is_inside);
    }

    std::vector<V2d> points_;
    std::vector<Links> links_;
    std::vector<bool> is_reflex_;        // In the ring as it is left.
    std::vector<std::uint32_t> reflex_;  // In the whole polygon.
    std::optional<PointGrid> grid_;      // Of these.
    std::size_t tests_left_ = 0;         // Spirals would need cubic time.
};

}  // namespace

void triangulate(std::span<const V3f> corners,
                 std::vector<std::array<std::uint32_t, 3>>& triangles) {
    if (corners.size() > 3) {
        Ring ring(corners);
        if (!ring.is_convex()) {
            ring.clip_ears(triangles);
            return;
        }
    }
    for (std::uint32_t i = 2; i < corners.size(); ++i) {
        triangles.push_back({0, i - 1, i});
    }
}

}  // namespace balcony::scene
