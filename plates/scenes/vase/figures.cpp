// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "scenes/vase/vase_painting.hpp"

namespace balcony::plates {

namespace {

// Draws in the coordinates of a figure.
class Brush {
public:
    Brush(Drawing& drawing, const Placement& placement)
        : drawing_(drawing), placement_(placement) {}

    void fill(const Path& outline, const Color& color) const {
        drawing_.fill(placed(outline, placement_), color);
    }
    void fill_smooth(const std::vector<V2d>& points, const Color& color) const {
        fill(smooth_outline(points), color);
    }
    void dot(const V2d& center, double radius, const Color& color) const {
        fill(ellipse(center, V2d(radius)), color);
    }
    void draw(const std::vector<V2d>& points, double width, const Color& color) const {
        fill(line(smooth_path(points), width), color);
    }
    /// Tapers from one width to another.
    void taper(const Path& path, double from, double to, const Color& color) const {
        fill(brush_stroke(path, [=](double t) { return std::lerp(from, to, t) / 2.0; }), color);
    }

private:
    Drawing& drawing_;
    Placement placement_;
};

// Goes on from a line in a spiral that closes in on its centre.
std::vector<V2d> with_spiral(std::vector<V2d> points, double radius, double turns, double sense) {
    const V2d end = points.back();
    const V2d along = (end - points[points.size() - 2]).normalized();
    const V2d to_center = V2d(-along.y, along.x) * sense;
    const V2d center = end + to_center * radius;
    const int steps = static_cast<int>(turns * 10.0);
    for (int k = 1; k <= steps; ++k) {
        const double part = static_cast<double>(k) / steps;
        const double angle = sense * 2.0 * std::numbers::pi * turns * part;
        const double r = radius * (1.0 - 0.8 * part);
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        points.push_back(
            center - V2d(c * to_center.x - s * to_center.y, s * to_center.x + c * to_center.y) * r);
    }
    return points;
}

void paint_oarsman(const Brush& brush, double x) {
    brush.taper({V2d(x, 0.17), V2d(x + 0.005, 0.26), V2d(x + 0.03, 0.345)}, 0.075, 0.06,
                vase_colors.slip);
    brush.fill(ellipse(V2d(x + 0.05, 0.405), V2d(0.033, 0.04)), vase_colors.slip);
    brush.fill({V2d(x + 0.06, 0.39), V2d(x + 0.115, 0.355), V2d(x + 0.05, 0.37)}, vase_colors.slip);
    brush.draw({V2d(x + 0.03, 0.33), V2d(x + 0.08, 0.28), V2d(x + 0.13, 0.27)}, 0.024,
               vase_colors.slip);
}

void paint_sail(const Brush& brush, SailEmblem emblem) {
    const std::vector<V2d> sail{V2d(-0.46, 1.02), V2d(-0.1, 1.0),   V2d(0.3, 1.0),
                                V2d(0.62, 1.02),  V2d(0.76, 0.84),  V2d(0.74, 0.64),
                                V2d(0.6, 0.5),    V2d(0.2, 0.54),   V2d(-0.16, 0.53),
                                V2d(-0.44, 0.49), V2d(-0.38, 0.66), V2d(-0.38, 0.86)};
    brush.fill_smooth(sail, vase_colors.white);
    Path border = smooth_outline(sail);
    border.push_back(border.front());
    if (emblem == SailEmblem::stripes) {
        for (const double x : {-0.18, 0.08, 0.34}) {
            brush.fill(line(smooth_path(std::vector<V2d>{V2d(x, 1.0), V2d(x + 0.075, 0.78),
                                                         V2d(x + 0.04, 0.54)}),
                            0.075),
                       vase_colors.red);
        }
    } else if (emblem == SailEmblem::spiral) {
        brush.taper(smooth_path(with_spiral({V2d(0.1, 0.58), V2d(0.22, 0.585)}, 0.17, 2.3, 1.0)),
                    0.04, 0.03, vase_colors.red);
    } else {
        Path star;
        for (int k = 0; k < 16; ++k) {
            const double angle = std::numbers::pi * k / 8.0;
            star.push_back(V2d(0.18, 0.77) +
                           V2d(std::cos(angle), std::sin(angle)) * (k % 2 == 0 ? 0.19 : 0.075));
        }
        brush.fill(star, vase_colors.red);
        brush.dot(V2d(0.18, 0.77), 0.035, vase_colors.white);
    }
    brush.fill(line(border, 0.014), vase_colors.slip);
}

}  // namespace

void paint_ship(Drawing& drawing, const Placement& placement, SailEmblem emblem) {
    const Brush brush(drawing, placement);
    // Mast, rigging and sail.
    for (const V2d& deck : {V2d(-1.04, 0.5), V2d(-0.6, 0.25), V2d(0.55, 0.24), V2d(0.98, 0.4)}) {
        brush.draw({V2d(0.1, 1.12), deck}, 0.009, vase_colors.slip);
    }
    brush.draw({V2d(-0.44, 0.49), V2d(-0.86, 0.34)}, 0.009, vase_colors.slip);
    brush.draw({V2d(0.6, 0.5), V2d(0.78, 0.28)}, 0.009, vase_colors.slip);
    brush.taper({V2d(0.1, 0.15), V2d(0.1, 1.16)}, 0.05, 0.03, vase_colors.slip);
    paint_sail(brush, emblem);
    brush.draw({V2d(-0.56, 1.05), V2d(0.1, 1.03), V2d(0.74, 1.06)}, 0.032, vase_colors.slip);
    // Crew.
    for (int k = 0; k < 8; ++k) {
        paint_oarsman(brush, -0.56 + 0.155 * k);
        const double x = -0.5 + 0.155 * k;
        brush.taper({V2d(x + 0.06, 0.26), V2d(x - 0.09, -0.1)}, 0.018, 0.018, vase_colors.slip);
        brush.taper({V2d(x - 0.07, -0.05), V2d(x - 0.11, -0.15)}, 0.03, 0.045, vase_colors.slip);
    }
    // The helmsman, and the steering oar.
    brush.taper({V2d(-0.86, 0.3), V2d(-0.84, 0.42), V2d(-0.82, 0.53)}, 0.12, 0.08,
                vase_colors.slip);
    brush.fill(ellipse(V2d(-0.8, 0.6), V2d(0.037, 0.046)), vase_colors.slip);
    brush.fill({V2d(-0.79, 0.585), V2d(-0.73, 0.54), V2d(-0.8, 0.56)}, vase_colors.slip);
    brush.draw({V2d(-0.82, 0.5), V2d(-0.76, 0.43), V2d(-0.72, 0.44)}, 0.028, vase_colors.slip);
    brush.taper({V2d(-0.7, 0.48), V2d(-1.02, -0.02)}, 0.02, 0.02, vase_colors.slip);
    brush.taper({V2d(-0.95, 0.08), V2d(-1.09, -0.13)}, 0.03, 0.08, vase_colors.slip);
    // The hull from its stern along the keel to the ram, up the stem and back along the deck.
    brush.fill_smooth(
        {V2d(-1.06, 0.46), V2d(-0.94, 0.22), V2d(-0.7, 0.06),  V2d(-0.3, 0.0),   V2d(0.3, 0.0),
         V2d(0.75, 0.01),  V2d(1.05, 0.03),  V2d(1.24, 0.085), V2d(1.05, 0.14),  V2d(0.98, 0.24),
         V2d(1.0, 0.4),    V2d(1.08, 0.52),  V2d(0.95, 0.5),   V2d(0.86, 0.34),  V2d(0.66, 0.24),
         V2d(0.2, 0.19),   V2d(-0.3, 0.19),  V2d(-0.66, 0.23), V2d(-0.88, 0.34), V2d(-0.98, 0.5)},
        vase_colors.slip);
    for (const double spread : {0.0, 0.05, 0.1}) {
        brush.taper(
            smooth_path(std::vector<V2d>{
                V2d(-1.0, 0.42), V2d(-1.1, 0.62 - spread), V2d(-1.1 - 0.5 * spread, 0.8 - spread),
                V2d(-1.0 - spread, 0.9 - 0.6 * spread), V2d(-0.9 - spread, 0.87 - 0.4 * spread)}),
            0.07, 0.02, vase_colors.slip);
    }
    brush.draw({V2d(-0.9, 0.26), V2d(-0.6, 0.15), V2d(0.0, 0.115), V2d(0.6, 0.15), V2d(0.84, 0.22)},
               0.014, vase_colors.clay);
    brush.draw(
        {V2d(-0.82, 0.15), V2d(-0.5, 0.08), V2d(0.0, 0.055), V2d(0.6, 0.06), V2d(0.96, 0.07)}, 0.03,
        vase_colors.red);
    brush.fill(ellipse(V2d(0.9, 0.24), V2d(0.065, 0.042)), vase_colors.white);
    brush.dot(V2d(0.91, 0.24), 0.024, vase_colors.slip);
}

void paint_dolphin(Drawing& drawing, const Placement& placement) {
    const Brush brush(drawing, placement);
    // Back and belly of a leap, from the tail to the beak.
    brush.fill_smooth(
        {V2d(-0.5, -0.13), V2d(-0.4, 0.04), V2d(-0.2, 0.2), V2d(0.05, 0.26), V2d(0.26, 0.2),
         V2d(0.37, 0.1), V2d(0.42, 0.02), V2d(0.53, -0.09), V2d(0.39, -0.05), V2d(0.27, -0.05),
         V2d(0.1, 0.02), V2d(-0.12, 0.05), V2d(-0.32, -0.03), V2d(-0.46, -0.18)},
        vase_colors.slip);
    brush.fill(smooth_outline(std::vector<V2d>{V2d(-0.14, 0.22), V2d(-0.13, 0.34), V2d(-0.2, 0.4),
                                               V2d(-0.02, 0.34), V2d(0.08, 0.24)}),
               vase_colors.slip);
    brush.fill_smooth({V2d(-0.47, -0.12), V2d(-0.6, -0.1), V2d(-0.7, -0.17), V2d(-0.58, -0.2),
                       V2d(-0.53, -0.32), V2d(-0.44, -0.34), V2d(-0.43, -0.2)},
                      vase_colors.slip);
    brush.taper(smooth_path(std::vector<V2d>{V2d(0.12, 0.04), V2d(0.06, -0.06), V2d(-0.03, -0.13)}),
                0.1, 0.02, vase_colors.slip);
    // Incised: the belly, the gill, the beak, the eye.
    brush.draw({V2d(-0.4, -0.06), V2d(-0.22, 0.07), V2d(0.02, 0.11), V2d(0.2, 0.05)}, 0.014,
               vase_colors.clay);
    brush.draw({V2d(0.2, 0.18), V2d(0.235, 0.07), V2d(0.21, -0.03)}, 0.014, vase_colors.clay);
    brush.draw({V2d(0.33, -0.01), V2d(0.41, -0.01), V2d(0.49, -0.06)}, 0.012, vase_colors.clay);
    brush.dot(V2d(0.315, 0.075), 0.026, vase_colors.white);
    brush.dot(V2d(0.32, 0.075), 0.012, vase_colors.slip);
}

void paint_octopus(Drawing& drawing, const Placement& placement) {
    const Brush brush(drawing, placement);
    struct Arm {
        std::vector<V2d> reach;
        double radius, turns, sense;
    };
    const std::vector<Arm> arms{
        {{V2d(0.1, 0.4), V2d(0.3, 0.62), V2d(0.62, 0.72), V2d(0.86, 0.9)}, 0.15, 1.15, -1.0},
        {{V2d(0.12, 0.34), V2d(0.45, 0.42), V2d(0.78, 0.38), V2d(1.08, 0.52)}, 0.15, 1.15, 1.0},
        {{V2d(0.1, 0.3), V2d(0.35, 0.16), V2d(0.66, 0.2), V2d(0.92, 0.12)}, 0.15, 1.15, 1.0},
        {{V2d(0.06, 0.28), V2d(0.14, 0.08), V2d(0.32, 0.0), V2d(0.48, -0.02)}, 0.1, 1.0, 1.0},
    };
    for (const double side : {-1.0, 1.0}) {
        for (std::size_t k = 0; k < arms.size(); ++k) {
            const Arm& arm = arms[k];
            std::vector<V2d> reach = arm.reach;
            for (std::size_t i = 0; i < reach.size(); ++i) {
                // The left arms are no mirror image of the right ones.
                const double wave = side < 0.0 ? 0.05 * std::sin(2.1 * double(i) + double(k)) : 0.0;
                reach[i] = V2d(side * reach[i].x, reach[i].y + wave);
            }
            const Path path =
                smooth_path(with_spiral(reach, arm.radius, arm.turns, side * arm.sense));
            brush.taper(path, 0.14, 0.05, vase_colors.slip);
            for (std::size_t i = 8; i + 12 < path.size(); i += 5) {
                const double part = static_cast<double>(i) / static_cast<double>(path.size());
                brush.dot(path[i], 0.022 * (1.0 - part) + 0.006, vase_colors.clay);
            }
        }
    }
    brush.fill_smooth(
        {V2d(0.0, 0.22), V2d(0.16, 0.3), V2d(0.19, 0.48), V2d(0.16, 0.6), V2d(0.27, 0.78),
         V2d(0.26, 1.0), V2d(0.1, 1.13), V2d(-0.1, 1.13), V2d(-0.26, 1.0), V2d(-0.27, 0.78),
         V2d(-0.16, 0.6), V2d(-0.19, 0.48), V2d(-0.16, 0.3)},
        vase_colors.slip);
    for (const double side : {-1.0, 1.0}) {
        brush.dot(V2d(side * 0.095, 0.5), 0.078, vase_colors.white);
        brush.dot(V2d(side * 0.095, 0.5), 0.055, vase_colors.red);
        brush.dot(V2d(side * 0.095, 0.5), 0.03, vase_colors.slip);
        brush.draw({V2d(side * 0.05, 0.66), V2d(side * 0.12, 0.84), V2d(side * 0.06, 1.02)}, 0.013,
                   vase_colors.clay);
        brush.draw({V2d(side * 0.12, 0.68), V2d(side * 0.19, 0.84), V2d(side * 0.14, 1.0)}, 0.013,
                   vase_colors.clay);
    }
}

void paint_gull(Drawing& drawing, const Placement& placement) {
    const Brush brush(drawing, placement);
    brush.fill_smooth({V2d(-0.16, 0.0), V2d(0.0, 0.04), V2d(0.12, 0.05), V2d(0.2, 0.02),
                       V2d(0.1, -0.02), V2d(-0.04, -0.03)},
                      vase_colors.slip);
    brush.taper(smooth_path(std::vector<V2d>{V2d(0.04, 0.02), V2d(-0.04, 0.17), V2d(-0.2, 0.24),
                                             V2d(-0.34, 0.22)}),
                0.08, 0.01, vase_colors.slip);
    brush.taper(smooth_path(std::vector<V2d>{V2d(0.05, 0.02), V2d(0.14, 0.16), V2d(0.3, 0.2)}),
                0.07, 0.01, vase_colors.slip);
}

}  // namespace balcony::plates
