// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/polygons/polygon.hpp"

#include <algorithm>
#include <cmath>

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

// The polygon as it is left: a ring of corners.
class Ring {
public:
    explicit Ring(std::span<const V3f> corners) : points_(flattened(corners)) {
        const auto count = static_cast<std::uint32_t>(points_.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            links_.push_back({(i + count - 1) % count, (i + 1) % count});
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            if (turn_at(i) < 0.0) {
                reflex_.push_back(i);
            }
        }
        tests_left_ = 4 * points_.size() * points_.size();
    }

    [[nodiscard]] bool is_convex() const { return reflex_.empty(); }

    void clip_ears(std::vector<std::array<std::uint32_t, 3>>& triangles) {
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
            std::erase_if(reflex_, [&](std::uint32_t corner) {
                return corner == at ||
                       ((corner == before || corner == after) && turn_at(corner) >= 0.0);
            });
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

    // Only a reflex corner can lie in the triangle of an ear.
    [[nodiscard]] bool is_ear(std::uint32_t corner) {
        if (turn_at(corner) < 0.0) {
            return false;
        }
        const V2d& a = points_[links_[corner].before];
        const V2d& b = points_[corner];
        const V2d& c = points_[links_[corner].next];
        return std::none_of(reflex_.begin(), reflex_.end(), [&](std::uint32_t other) {
            if (tests_left_ == 0) {
                return false;
            }
            --tests_left_;
            const V2d& p = points_[other];
            return p != a && p != b && p != c && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 &&
                   turn(c, a, p) >= 0.0;
        });
    }

    std::vector<V2d> points_;
    std::vector<Links> links_;
    std::vector<std::uint32_t> reflex_;
    std::size_t tests_left_ = 0;  // Spirals would need cubic time.
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
