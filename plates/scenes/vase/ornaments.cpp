// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>
#include <numbers>

#include "scenes/vase/vase_painting.hpp"

namespace balcony::plates {

namespace {

Path box(const V2d& low, const V2d& high) {
    return {low, V2d(high.x, low.y), high, V2d(low.x, high.y)};
}

// A petal of a fan: pointed at its root, round at its end.
Path petal(double angle, double length, double width) {
    const V2d direction(std::sin(angle), std::cos(angle));
    const Path middle{direction * (0.2 * length), direction * (0.4 * length),
                      direction * (0.6 * length), direction * (0.8 * length), direction * length};
    return brush_stroke(smooth_path(middle),
                        [width](double t) { return width * (0.15 + 0.85 * t * t); });
}

}  // namespace

void fill_band(Drawing& drawing, double low, double high, const Color& color) {
    drawing.fill(box(V2d(0.0, low), V2d(drawing.length(), high)), color);
}

void paint_rays(Drawing& drawing, double low, double high, int count) {
    const double step = drawing.length() / count;
    for (int k = 0; k < count; ++k) {
        const double x = (k + 0.5) * step;
        drawing.fill({V2d(x - 0.36 * step, low), V2d(x + 0.36 * step, low), V2d(x, high)},
                     vase_colors.slip);
    }
}

void paint_meander(Drawing& drawing, double low, double high, int count) {
    // One turn of the key, on a grid of which its period is four units and its height three.
    const std::array<V2d, 9> key{V2d(0, 0), V2d(0, 3), V2d(3, 3), V2d(3, 1), V2d(2, 1),
                                 V2d(2, 2), V2d(1, 2), V2d(1, 0), V2d(4, 0)};
    const V2d unit(drawing.length() / count / 4.0, (high - low) / 3.5);
    const V2d half = unit * 0.25;
    for (int k = 0; k < count; ++k) {
        const V2d start(4.0 * k * unit.x, low + half.y);
        for (std::size_t i = 0; i + 1 < key.size(); ++i) {
            const V2d a = start + key[i] * unit;
            const V2d b = start + key[i + 1] * unit;
            drawing.fill(box(V2d(std::min(a.x, b.x), std::min(a.y, b.y)) - half,
                             V2d(std::max(a.x, b.x), std::max(a.y, b.y)) + half),
                         vase_colors.slip);
        }
    }
}

void paint_waves(Drawing& drawing, double low, double high, int count) {
    const double step = drawing.length() / count;
    const std::array<V2d, 9> crest{V2d(-0.45, 0.0), V2d(0.05, 0.1), V2d(0.42, 0.3),
                                   V2d(0.64, 0.6),  V2d(0.6, 0.86), V2d(0.4, 0.94),
                                   V2d(0.24, 0.78), V2d(0.28, 0.6), V2d(0.42, 0.6)};
    const Path curl =
        brush_stroke(smooth_path(crest), [](double t) { return 0.2 * (1.0 - t) + 0.045; });
    fill_band(drawing, low, low + 0.18 * (high - low), vase_colors.slip);
    for (int k = 0; k < count; ++k) {
        drawing.fill(placed(curl, {.scale = V2d(step * 0.95, high - low),
                                   .offset = V2d((k + 0.5) * step, low)}),
                     vase_colors.slip);
    }
}

void paint_tongues(Drawing& drawing, double low, double high, int count) {
    const double step = drawing.length() / count;
    const auto tongue = [&](double x, double half, double bottom) {
        Path path = arc(V2d(0.0), half, std::numbers::pi, 2.0 * std::numbers::pi);
        path = placed(path, {.offset = V2d(x, bottom + half)});
        path.emplace_back(x + half, high);
        path.emplace_back(x - half, high);
        return path;
    };
    for (int k = 0; k < count; ++k) {
        const double x = (k + 0.5) * step;
        drawing.fill(tongue(x, 0.46 * step, low), vase_colors.slip);
        drawing.fill(tongue(x, 0.36 * step, low + 0.1 * step), vase_colors.clay);
        drawing.fill(tongue(x, 0.27 * step, low + 0.19 * step),
                     k % 2 == 0 ? vase_colors.slip : vase_colors.red);
    }
}

void paint_palmettes(Drawing& drawing, double low, double high, int count, double stretch) {
    const double height = high - low;
    const double step = drawing.length() / count;
    for (int k = 0; k < count; ++k) {
        const bool upright = k % 2 == 0;
        const double side = upright ? 1.0 : -1.0;
        const Placement at{.scale = V2d(stretch * height, side * height),
                           .offset = V2d((k + 0.5) * step, upright ? low : high)};
        constexpr int petals = 4;  // On either side of the middle one.
        for (int i = -petals; i <= petals; ++i) {
            const double length = 0.9 - 0.03 * i * i;
            drawing.fill(placed(petal(0.34 * i, length, 0.075), at), vase_colors.slip);
        }
        drawing.fill(placed(ellipse(V2d(0.0, 0.1), V2d(0.14, 0.12)), at), vase_colors.red);
        for (const double mirrored : {-1.0, 1.0}) {
            const std::array<V2d, 8> volute{V2d(0.0, -0.01), V2d(0.2, -0.01), V2d(0.36, 0.06),
                                            V2d(0.4, 0.17),  V2d(0.33, 0.25), V2d(0.25, 0.2),
                                            V2d(0.27, 0.13), V2d(0.32, 0.14)};
            const Path curl =
                placed(line(smooth_path(volute), 0.05), {.scale = V2d(mirrored, 1.0)});
            drawing.fill(placed(curl, at), vase_colors.slip);
        }
    }
}

}  // namespace balcony::plates
