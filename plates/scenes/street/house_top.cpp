// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <vector>

#include "scenes/street/house_parts.hpp"

namespace balcony::plates::street {

namespace {

class HouseTop {
public:
    HouseTop(HouseParts& parts, const Plan& plan, double eaves, std::uint32_t seed)
        : parts_(parts), plan_(plan), eaves_(eaves), seed_(seed) {}

    void build() {
        add_top();
        add_chimney();
    }

private:
    [[nodiscard]] double dice(int a, int b) const { return lattice_noise(a, b, seed_); }

    void add_top() {
        switch (plan_.top) {
            case Top::eaves: add_eaves_roof(parts_.roof, 0.9, 0.4); break;
            case Top::mansard: add_mansard(); break;
            case Top::flat: add_parapet(); break;
            default: add_gable(); break;
        }
    }

    void add_cornice(double out) {
        const double w = plan_.width;
        parts_.trim.box(V3d(0, -out * 0.4, eaves_ - 0.4), V3d(w, 0.02, eaves_ - 0.25));
        parts_.trim.box(V3d(0, -out, eaves_ - 0.14), V3d(w, 0.05, eaves_));
        parts_.trim.box(V3d(0, -out * 0.75, eaves_ - 0.25), V3d(w, 0.03, eaves_ - 0.14));
        const int blocks = static_cast<int>(w / 0.45);
        for (int i = 0; i < blocks; ++i) {
            const double x = w * (i + 0.5) / blocks;
            parts_.trim.box(V3d(x - 0.06, -out * 0.7, eaves_ - 0.32),
                            V3d(x + 0.06, 0.0, eaves_ - 0.2));
        }
    }

    // The ridge along the street; the slope and how far the eaves project.
    void add_eaves_roof(MeshBuilder& tiles, double slope, double out) {
        const double w = plan_.width;
        add_cornice(0.3);
        const double ridge = eaves_ + slope * house_depth / 2;
        const V3d a(0, -out, eaves_ - 0.02);
        const V3d b(w, -out, eaves_ - 0.02);
        const V3d c(w, house_depth / 2, ridge);
        const V3d d(0, house_depth / 2, ridge);
        tiles.quad(a, b, c, d).quad(V3d(w, house_depth, eaves_), V3d(0, house_depth, eaves_), d, c);
        parts_.sides.triangle(V3d(0, house_depth, eaves_), V3d(0, 0, eaves_), d);
        parts_.sides.triangle(V3d(w, 0, eaves_), V3d(w, house_depth, eaves_), c);
        const int dormers = std::max(1, plan_.windows - 1);
        for (int i = 0; i < dormers; ++i) {
            add_dormer(w * (i + 0.5) / dormers, 0.9, eaves_ + 0.75, tiles);
        }
    }

    void add_dormer(double middle, double y, double z, MeshBuilder& tiles) {
        const double left = middle - 0.42;
        const double right = middle + 0.42;
        const double head = z + 1.05;
        MeshBuilder& wood = parts_.frames;
        wood.box(V3d(left - 0.1, y, z - 0.1), V3d(left, y + 2.0, head + 0.05));
        wood.box(V3d(right, y, z - 0.1), V3d(right + 0.1, y + 2.0, head + 0.05));
        wood.box(V3d(left, y, z - 0.1), V3d(right, y + 0.1, z));
        wood.box(V3d(middle - 0.03, y + 0.03, z), V3d(middle + 0.03, y + 0.1, head));
        wood.band({{left - 0.1, head}, {middle, head}, {right + 0.1, head}},
                  {{left - 0.1, head + 0.01}, {middle, head + 0.43}, {right + 0.1, head + 0.01}}, y,
                  y + 0.1);
        const bool lit = dice(static_cast<int>(middle * 8), 9) > 0.6;
        const double pane = y + 0.08;
        (lit ? parts_.lamplight : parts_.glass)
            .quad(V3d(left, pane, z), V3d(right, pane, z), V3d(right, pane, head),
                  V3d(left, pane, head));
        tiles.band({{left - 0.22, head}, {middle, head + 0.45}, {right + 0.22, head}},
                   {{left - 0.22, head + 0.08}, {middle, head + 0.55}, {right + 0.22, head + 0.08}},
                   y - 0.15, y + 2.4);
    }

    void add_mansard() {
        const double w = plan_.width;
        add_cornice(0.38);
        const double top = eaves_ + 2.5;
        const V3d a(0, 0, eaves_);
        const V3d b(w, 0, eaves_);
        const V3d c(w, 1.0, top);
        const V3d d(0, 1.0, top);
        parts_.slate.quad(a, b, c, d);
        parts_.slate.quad(d, c, V3d(w, house_depth, top + 1.0), V3d(0, house_depth, top + 1.0));
        parts_.sides.quad(V3d(0, house_depth, eaves_), a, d, V3d(0, house_depth, top + 1.0));
        parts_.sides.quad(b, V3d(w, house_depth, eaves_), V3d(w, house_depth, top + 1.0), c);
        parts_.trim.box(V3d(0, 0.9, top - 0.06), V3d(w, 1.15, top + 0.1));
        for (int i = 0; i < plan_.windows; ++i) {
            add_dormer(w * (i + 0.5) / plan_.windows, 0.15, eaves_ + 0.45, parts_.slate);
        }
    }

    void add_parapet() {
        const double w = plan_.width;
        add_cornice(0.45);
        parts_.trim.box(V3d(0, 0.0, eaves_), V3d(w, 0.3, eaves_ + 0.85));
        parts_.trim.box(V3d(0, -0.1, eaves_ + 0.85), V3d(w, 0.35, eaves_ + 0.98));
        const int panels = std::max(2, plan_.windows);
        for (int i = 0; i <= panels; ++i) {
            const double x = std::clamp(w * i / panels, 0.2, w - 0.2);
            parts_.trim.box(V3d(x - 0.2, -0.06, eaves_), V3d(x + 0.2, 0.3, eaves_ + 1.02));
            if (i % 2 == 0) {
                parts_.trim.lathe(
                    V3d(x, 0.14, eaves_ + 1.02),
                    {{0.12, 0}, {0.07, 0.08}, {0.2, 0.3}, {0.22, 0.42}, {0.1, 0.52}, {0.0, 0.6}},
                    12);
            }
        }
        parts_.slate.quad(V3d(0, 0, eaves_), V3d(w, 0, eaves_), V3d(w, house_depth, eaves_),
                          V3d(0, house_depth, eaves_));
    }

    // The outline of a gable from left to right, heights above the eaves.
    [[nodiscard]] std::vector<V2d> gable_outline() const {
        const double w = plan_.width;
        std::vector<V2d> outline;
        if (plan_.top == Top::pediment) {
            return {{0.0, 0.0}, {w / 2, w * 0.36}, {w, 0.0}};
        }
        if (plan_.top == Top::stepped) {
            constexpr int steps = 5;
            const double run = w / (2 * steps + 1);
            for (int i = 0; i < 2 * steps + 1; ++i) {
                const double z = 0.5 + 0.78 * run * 1.35 * std::min(i, 2 * steps - i);
                outline.emplace_back(run * i, z);
                outline.emplace_back(run * (i + 1), z);
            }
            return outline;
        }
        // A bell: concave below, a round head on top.
        constexpr int steps = 24;
        for (int i = 0; i <= steps; ++i) {
            const double s = std::fabs(2.0 * i / steps - 1.0);  // 1 at the sides, 0 in the middle
            const double shoulder = 0.3 + 2.3 * std::pow(1.0 - smooth_step(0.35, 1.0, s), 1.6);
            const double head = s < 0.36 ? std::sqrt(1.0 - std::pow(s / 0.36, 2.0)) * 0.75 : 0.0;
            outline.emplace_back(w * i / steps, shoulder + head);
        }
        return outline;
    }

    void add_gable() {
        const double w = plan_.width;
        const std::vector<V2d> outline = gable_outline();
        std::vector<V2d> lower, upper, capped;
        double highest = 0.0;
        for (const V2d& p : outline) {
            lower.emplace_back(p.x, eaves_);
            upper.emplace_back(p.x, eaves_ + p.y);
            capped.emplace_back(p.x, eaves_ + p.y + 0.13);
            highest = std::max(highest, p.y);
        }
        parts_.front.band(lower, upper, 0.0, 0.35);
        parts_.trim.band(upper, capped, -0.08, 0.42);
        parts_.trim.box(V3d(0, -0.1, eaves_ - 0.12), V3d(w, 0.02, eaves_ + 0.02));
        const double ridge = eaves_ + highest * 0.8;
        const V3d a(w / 2, 0.3, ridge);
        const V3d b(w / 2, house_depth, ridge);
        parts_.roof.quad(V3d(0, house_depth, eaves_), V3d(0, 0.3, eaves_), a, b);
        parts_.roof.quad(V3d(w, 0.3, eaves_), V3d(w, house_depth, eaves_), b, a);
        // A round or an upright window in the gable, and a ball on its top.
        parts_.frames.box(V3d(w / 2 - 0.5, -0.03, eaves_ + 0.45),
                          V3d(w / 2 + 0.5, 0.02, eaves_ + 1.65), 0.02);
        parts_.lamplight.quad(
            V3d(w / 2 - 0.4, -0.035, eaves_ + 0.55), V3d(w / 2 + 0.4, -0.035, eaves_ + 0.55),
            V3d(w / 2 + 0.4, -0.035, eaves_ + 1.55), V3d(w / 2 - 0.4, -0.035, eaves_ + 1.55));
        parts_.frames.box(V3d(w / 2 - 0.03, -0.05, eaves_ + 0.5),
                          V3d(w / 2 + 0.03, -0.03, eaves_ + 1.6));
        parts_.trim.lathe(
            V3d(w / 2, 0.15, eaves_ + highest + 0.1),
            {{0.16, 0}, {0.16, 0.12}, {0.06, 0.16}, {0.17, 0.36}, {0.12, 0.5}, {0.0, 0.56}}, 12);
    }

    void add_chimney() {
        const double x = plan_.width * (dice(3, 3) < 0.5 ? 0.14 : 0.86);
        const double y = plan_.top == Top::flat ? 2.5 : 3.6;
        const double top = eaves_ + (plan_.top == Top::flat ? 2.2 : 4.6);
        parts_.sides.box(V3d(x - 0.45, y, eaves_ - 1.0), V3d(x + 0.45, y + 0.7, top));
        parts_.trim.box(V3d(x - 0.55, y - 0.08, top - 0.22), V3d(x + 0.55, y + 0.78, top - 0.05));
        for (const double side : {-0.22, 0.22}) {
            parts_.roof.lathe(V3d(x + side, y + 0.35, top),
                              {{0.13, 0}, {0.11, 0.45}, {0.14, 0.5}, {0.09, 0.5}}, 10);
        }
    }

    HouseParts& parts_;
    const Plan& plan_;
    double eaves_;
    std::uint32_t seed_;
};

}  // namespace

void add_house_top(HouseParts& parts, const Plan& plan, double eaves, std::uint32_t seed) {
    HouseTop(parts, plan, eaves, seed).build();
}

}  // namespace balcony::plates::street
