// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "common/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace balcony::plates {

namespace {

constexpr int pieces_per_segment = 12;
constexpr int scanlines_per_pixel = 4;

double distance(const V2d& a, const V2d& b) { return (b - a).length(); }

// The point at t from 0 (b) to 1 (c) of the segment between b and c (P. J. Barry, R. N. Goldman,
// "A recursive evaluation algorithm for a class of Catmull-Rom splines", 1988).
V2d catmull_rom(const V2d& a, const V2d& b, const V2d& c, const V2d& d, double t) {
    const auto knot = [](const V2d& p, const V2d& q) {
        return std::max(std::sqrt(distance(p, q)), 1e-9);
    };
    const double ta = 0.0;
    const double tb = ta + knot(a, b);
    const double tc = tb + knot(b, c);
    const double td = tc + knot(c, d);
    const double at = std::lerp(tb, tc, t);
    const auto between = [at](const V2d& p, const V2d& q, double from, double to) {
        return p + (q - p) * ((at - from) / (to - from));
    };
    const V2d ab = between(a, b, ta, tb);
    const V2d bc = between(b, c, tb, tc);
    const V2d cd = between(c, d, tc, td);
    return between(between(ab, bc, ta, tc), between(bc, cd, tb, td), tb, tc);
}

}  // namespace

Path smooth_path(std::span<const V2d> points) {
    Path path;
    const auto last = static_cast<int>(points.size()) - 1;
    const auto point = [&](int i) {
        // Beyond an end, the point that continues the last segment.
        if (i < 0) {
            return points.front() * 2.0 - points[1];
        }
        if (i > last) {
            return points.back() * 2.0 - points[static_cast<std::size_t>(last - 1)];
        }
        return points[static_cast<std::size_t>(i)];
    };
    for (int i = 0; i < last; ++i) {
        for (int k = 0; k < pieces_per_segment; ++k) {
            path.push_back(catmull_rom(point(i - 1), point(i), point(i + 1), point(i + 2),
                                       double(k) / pieces_per_segment));
        }
    }
    path.push_back(points.back());
    return path;
}

Path smooth_outline(std::span<const V2d> points) {
    Path path;
    const auto count = points.size();
    const auto point = [&](std::size_t i) { return points[i % count]; };
    for (std::size_t i = 0; i < count; ++i) {
        for (int k = 0; k < pieces_per_segment; ++k) {
            path.push_back(catmull_rom(point(i + count - 1), point(i), point(i + 1), point(i + 2),
                                       double(k) / pieces_per_segment));
        }
    }
    return path;
}

Path brush_stroke(const Path& path, const std::function<double(double)>& half_width) {
    double length = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        length += distance(path[i - 1], path[i]);
    }
    Path left;
    Path right;
    double walked = 0.0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        walked += i > 0 ? distance(path[i - 1], path[i]) : 0.0;
        const V2d along =
            (path[std::min(i + 1, path.size() - 1)] - path[i > 0 ? i - 1 : 0]).normalized();
        const V2d across = V2d(-along.y, along.x) * half_width(walked / length);
        left.push_back(path[i] + across);
        right.push_back(path[i] - across);
    }
    // Half a circle from the left to the right side at the end, and back at the start.
    const auto cap = [](Path& outline, const V2d& center, const V2d& from) {
        for (int k = 1; k < pieces_per_segment; ++k) {
            const double angle = -std::numbers::pi * k / pieces_per_segment;
            const double c = std::cos(angle);
            const double s = std::sin(angle);
            outline.push_back(center + V2d(c * from.x - s * from.y, s * from.x + c * from.y));
        }
    };
    Path outline = left;
    cap(outline, path.back(), left.back() - path.back());
    outline.insert(outline.end(), right.rbegin(), right.rend());
    cap(outline, path.front(), right.front() - path.front());
    return outline;
}

Path line(const Path& path, double width) {
    return brush_stroke(path, [half = width / 2.0](double) { return half; });
}

Path ellipse(const V2d& center, const V2d& radii) {
    Path path = arc(V2d(0.0), 1.0, 0.0, 2.0 * std::numbers::pi);
    return placed(std::move(path), {.scale = radii, .offset = center});
}

Path arc(const V2d& center, double radius, double from, double to) {
    const int pieces = std::max(8, static_cast<int>(std::abs(to - from) * 16.0));
    Path path;
    for (int k = 0; k <= pieces; ++k) {
        const double angle = std::lerp(from, to, double(k) / pieces);
        path.push_back(center + V2d(std::cos(angle), std::sin(angle)) * radius);
    }
    return path;
}

Path placed(Path path, const Placement& placement) {
    const double c = std::cos(placement.angle);
    const double s = std::sin(placement.angle);
    for (V2d& point : path) {
        const V2d p = point * placement.scale;
        point = V2d(c * p.x - s * p.y, s * p.x + c * p.y) + placement.offset;
    }
    return path;
}

Drawing::Drawing(int pixels_round, double length, double height, const Color& ground)
    : length_(length),
      height_(height),
      columns_(pixels_round),
      rows_(static_cast<int>(std::lround(height * pixels_round / length))),
      pixels_per_unit_(pixels_round / length),
      pixels_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), ground) {}

void Drawing::fill(const Path& outline, const Color& color) {
    const auto [lowest, highest] = std::minmax_element(
        outline.begin(), outline.end(), [](const V2d& a, const V2d& b) { return a.y < b.y; });
    const auto row_of = [&](double y) {
        return static_cast<int>(std::floor((height_ - y) * pixels_per_unit_));
    };
    const int last = std::min(row_of(lowest->y), rows_ - 1);
    for (int row = std::max(row_of(highest->y), 0); row <= last; ++row) {
        fill_row(outline, row, color);
    }
}

void Drawing::fill_row(const Path& outline, int row, const Color& color) {
    struct Crossing {
        double x;  // Pixels.
        int turn;  // 1 where the outline goes up, -1 where it goes down.
    };
    const auto [leftmost, rightmost] = std::minmax_element(
        outline.begin(), outline.end(), [](const V2d& a, const V2d& b) { return a.x < b.x; });
    const int first = static_cast<int>(std::floor(leftmost->x * pixels_per_unit_));
    const int last = static_cast<int>(std::floor(rightmost->x * pixels_per_unit_));
    std::vector<double> coverage(static_cast<std::size_t>(last - first + 1), 0.0);
    std::vector<Crossing> crossings;
    for (int k = 0; k < scanlines_per_pixel; ++k) {
        const double y = height_ - (row + (k + 0.5) / scanlines_per_pixel) / pixels_per_unit_;
        crossings.clear();
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const V2d& a = outline[i];
            const V2d& b = outline[(i + 1) % outline.size()];
            if ((a.y <= y) != (b.y <= y)) {
                const double x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
                crossings.push_back({x * pixels_per_unit_, b.y > a.y ? 1 : -1});
            }
        }
        std::sort(crossings.begin(), crossings.end(),
                  [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
        int winding = 0;
        for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
            winding += crossings[i].turn;
            const double from = crossings[i].x;
            const double to = crossings[i + 1].x;
            for (int x = static_cast<int>(std::floor(from)); winding != 0 && x < to; ++x) {
                coverage[static_cast<std::size_t>(x - first)] +=
                    (std::min(to, x + 1.0) - std::max(from, double(x))) / scanlines_per_pixel;
            }
        }
    }
    for (int x = first; x <= last; ++x) {
        const int column = (x % columns_ + columns_) % columns_;
        Color& pixel = pixels_[static_cast<std::size_t>(row * columns_ + column)];
        pixel = mix(pixel, color, std::min(coverage[static_cast<std::size_t>(x - first)], 1.0));
    }
}

Color Drawing::at(const V2d& place) const {
    const int x = static_cast<int>(std::floor(place.x * pixels_per_unit_));
    const int row = static_cast<int>(std::floor((height_ - place.y) * pixels_per_unit_));
    const int column = (x % columns_ + columns_) % columns_;
    return pixels_[static_cast<std::size_t>(std::clamp(row, 0, rows_ - 1) * columns_ + column)];
}

}  // namespace balcony::plates
