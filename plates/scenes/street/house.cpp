// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/street/house.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace balcony::plates::street {

namespace {

using scene::MaterialIndex;

constexpr double ground_height = 3.7;
constexpr double storey_height = 3.15;
constexpr double depth = 9.0;   // Of a house.
constexpr double reveal = 0.2;  // From the front to the glass.

struct Opening {
    double from, to;    // Along x.
    double sill, head;  // Heights.
    bool arched = false;
    [[nodiscard]] double width() const { return to - from; }
};

// The number of a house, for what differs from house to house.
std::uint32_t seed_of(const std::string& name) {
    std::uint32_t seed = 0;
    for (const char c : name) {
        seed = seed * 31U + static_cast<unsigned char>(c);
    }
    return seed;
}

class House {
public:
    House(const std::string& name, const Plan& plan)
        : plan_(plan),
          seed_(seed_of(name)),
          eaves_(ground_height + storey_height * (plan.storeys - 1) + 0.35) {
        add_ground_floor();
        for (int storey = 1; storey < plan_.storeys; ++storey) {
            add_storey(storey);
        }
        add_body();
        add_top();
        add_chimney();
        if (plan_.balcony) {
            add_balcony();
        }
    }

    MeshBuilder front, trim, frames, glass, curtain, lamplight, roof, slate, sides, accent, iron,
        leaves, flowers;

private:
    [[nodiscard]] double dice(int a, int b) const { return lattice_noise(a, b, seed_); }

    // A strip of the front between two heights, with openings from left to right.
    void add_wall(double low, double high, const std::vector<Opening>& openings) {
        const auto rectangle = [&](double from, double to, double bottom, double top) {
            if (to - from > 1e-6 && top - bottom > 1e-6) {
                front.quad(V3d(from, 0, bottom), V3d(to, 0, bottom), V3d(to, 0, top),
                           V3d(from, 0, top));
            }
        };
        double x = 0.0;
        for (const Opening& o : openings) {
            rectangle(x, o.from, low, high);
            rectangle(o.from, o.to, low, o.sill);
            rectangle(o.from, o.to, o.head, high);
            const V3d in(0, reveal, 0);
            const std::array<V3d, 4> rim{V3d(o.from, 0, o.sill), V3d(o.to, 0, o.sill),
                                         V3d(o.to, 0, o.head), V3d(o.from, 0, o.head)};
            for (std::size_t i = 0; i < 4; ++i) {
                const std::size_t next = (i + 1) % 4;
                front.quad(rim[i] + in, rim[next] + in, rim[next], rim[i]);
            }
            if (o.arched) {
                add_arch(o);
            }
            x = o.to;
        }
        rectangle(x, plan_.width, low, high);
    }

    // Fills the corners above a round arch.
    void add_arch(const Opening& o) {
        constexpr int steps = 12;
        const double radius = o.width() / 2.0;
        std::vector<V2d> arc, flat;
        for (int k = 0; k <= steps; ++k) {
            const double angle = std::numbers::pi * (1.0 - static_cast<double>(k) / steps);
            arc.emplace_back((o.from + o.to) / 2.0 + radius * std::cos(angle),
                             o.head - radius + radius * std::sin(angle));
            flat.emplace_back(arc.back().x, o.head);
        }
        front.band(arc, flat, 0.0, reveal);
    }

    // Frame with bars, glass or curtain or light behind it.
    void add_window(const Opening& o, int columns, int rows, double light) {
        constexpr double bar = 0.07;
        const double front_of_frame = reveal - 0.06;
        const auto box = [&](double from, double to, double bottom, double top, double out) {
            frames.box(V3d(from, front_of_frame - out, bottom), V3d(to, reveal, top));
        };
        box(o.from, o.from + bar, o.sill, o.head, 0.01);
        box(o.to - bar, o.to, o.sill, o.head, 0.01);
        box(o.from, o.to, o.sill, o.sill + bar, 0.02);
        box(o.from, o.to, o.head - bar, o.head, 0.01);
        for (int i = 1; i < columns; ++i) {
            const double x = o.from + o.width() * i / columns;
            box(x - 0.03, x + 0.03, o.sill, o.head, 0.0);
        }
        for (int i = 1; i < rows; ++i) {
            const double z = o.sill + (o.head - o.sill) * i / rows;
            box(o.from, o.to, z - 0.025, z + 0.025, -0.01);
        }
        MeshBuilder& pane = light < 0.62 ? glass : light < 0.82 ? curtain : lamplight;
        pane.quad(V3d(o.from, reveal - 0.02, o.sill), V3d(o.to, reveal - 0.02, o.sill),
                  V3d(o.to, reveal - 0.02, o.head), V3d(o.from, reveal - 0.02, o.head));
    }

    void add_storey(int storey) {
        const double low = ground_height + storey_height * (storey - 1);
        const bool last = storey == plan_.storeys - 1;
        const double high = last ? eaves_ : low + storey_height;
        const double pitch = plan_.width / plan_.windows;
        const double width = std::min(pitch * 0.56, plan_.windows <= 2 ? 1.5 : 1.15);
        const double tall = (plan_.arched ? 2.05 : 1.95) - 0.12 * storey;
        std::vector<Opening> row;
        for (int i = 0; i < plan_.windows; ++i) {
            const double middle = pitch * (i + 0.5);
            row.push_back({middle - width / 2, middle + width / 2, low + 0.72, low + 0.72 + tall,
                           plan_.arched});
        }
        add_wall(low, high, row);
        for (int i = 0; i < plan_.windows; ++i) {
            const Opening& o = row[static_cast<std::size_t>(i)];
            const bool sash = (seed_ & 1U) != 0U;
            add_window(o, 2, sash ? 3 : 2, dice(i, storey));
            trim.box(V3d(o.from - 0.1, -0.1, o.sill - 0.09), V3d(o.to + 0.1, 0.06, o.sill));
            if (plan_.wall == Wall::brick && !plan_.arched) {
                trim.box(V3d(o.from - 0.14, -0.025, o.head), V3d(o.to + 0.14, 0.02, o.head + 0.22));
            } else if (!plan_.arched) {
                trim.box(V3d(o.from - 0.12, -0.035, o.sill), V3d(o.from, 0.02, o.head + 0.12));
                trim.box(V3d(o.to, -0.035, o.sill), V3d(o.to + 0.12, 0.02, o.head + 0.12));
                trim.box(V3d(o.from - 0.17, -0.09, o.head + 0.12),
                         V3d(o.to + 0.17, 0.02, o.head + 0.2));
            }
            if (dice(i + 7, storey) > 0.72 && !plan_.balcony) {
                accent.box(V3d(o.from, -0.26, o.sill), V3d(o.to, -0.08, o.sill + 0.16));
                for (int k = 0; k < 9; ++k) {
                    const double x = o.from + o.width() * (k + 0.5) / 9.0;
                    MeshBuilder& plant = k % 2 == 0 ? leaves : flowers;
                    plant.ellipsoid(V3d(x, -0.18, o.sill + 0.2 + 0.06 * dice(k, i)),
                                    V3d(0.11, 0.12, 0.11), 6);
                }
            }
        }
        if (plan_.wall == Wall::plaster) {
            trim.box(V3d(0, -0.06, low - 0.09), V3d(plan_.width, 0.02, low + 0.06));
        }
    }

    void add_ground_floor() {
        switch (plan_.ground) {
            case Ground::door: add_door_floor(); break;
            case Ground::arcade: add_arches(); break;
            case Ground::shop:
            case Ground::cafe: add_shop(); break;
        }
        // Plinth and the moulding above the ground floor.
        trim.box(V3d(0, -0.07, ground_height - 0.16), V3d(plan_.width, 0.02, ground_height));
        trim.box(V3d(0, -0.12, ground_height - 0.04), V3d(plan_.width, 0.02, ground_height + 0.04));
    }

    void add_door(const Opening& o) {
        const double leaf = o.head - 0.55;
        accent.box(V3d(o.from, reveal - 0.06, o.sill), V3d(o.to, reveal, leaf));
        for (const double part : {0.06, 0.54}) {
            const double x = o.from + o.width() * part;
            for (const double z : {0.2, 1.15}) {
                accent.box(V3d(x, reveal - 0.085, o.sill + z),
                           V3d(x + o.width() * 0.4, reveal, o.sill + z + 0.8), 0.03);
            }
        }
        add_window({o.from, o.to, leaf, o.head}, 3, 1, 0.9);
        trim.box(V3d(o.from - 0.16, -0.06, 0), V3d(o.from, 0.03, o.head + 0.1));
        trim.box(V3d(o.to, -0.06, 0), V3d(o.to + 0.16, 0.03, o.head + 0.1));
        trim.box(V3d(o.from - 0.24, -0.2, o.head + 0.1), V3d(o.to + 0.24, 0.03, o.head + 0.24));
        trim.box(V3d(o.from - 0.2, -0.75, 0), V3d(o.to + 0.2, 0.03, 0.15));
        trim.box(V3d(o.from - 0.2, -0.4, 0), V3d(o.to + 0.2, 0.03, 0.3));
    }

    void add_door_floor() {
        const bool left = dice(1, 1) < 0.5;
        const int windows = std::max(1, plan_.windows - 1);
        const double pitch = plan_.width / (windows + 1);
        std::vector<Opening> openings;
        for (int i = 0; i <= windows; ++i) {
            const double middle = pitch * (i + 0.5);
            const bool door = i == (left ? 0 : windows);
            const double half = door ? 0.56 : std::min(0.75, pitch * 0.3);
            openings.push_back({middle - half, middle + half, door ? 0.3 : 1.0, 3.05});
        }
        add_wall(0.0, ground_height, openings);
        for (int i = 0; i <= windows; ++i) {
            const Opening& o = openings[static_cast<std::size_t>(i)];
            if (i == (left ? 0 : windows)) {
                add_door(o);
            } else {
                add_window(o, 2, 2, dice(i, 0));
                trim.box(V3d(o.from - 0.1, -0.1, o.sill - 0.1), V3d(o.to + 0.1, 0.06, o.sill));
                trim.box(V3d(o.from - 0.14, -0.03, o.head), V3d(o.to + 0.14, 0.02, o.head + 0.2));
            }
        }
        trim.box(V3d(0, -0.05, 0), V3d(openings[0].from - 0.17, 0.02, 0.5));
    }

    // A wide window and a door between posts, a board for a sign, an awning.
    void add_shop() {
        const double w = plan_.width;
        const Opening window{0.5, w - 1.75, 0.55, 2.95};
        const Opening door{w - 1.5, w - 0.5, 0.1, 2.95};
        add_wall(0.0, ground_height, {window, door});
        add_window(window, std::max(3, static_cast<int>(w / 1.6)), 1, 0.95);
        add_window({door.from, door.to, 0.1, 2.95}, 1, 2, 0.9);
        accent.box(V3d(0.25, -0.1, 3.0), V3d(w - 0.25, 0.02, 3.5), 0.03);
        accent.box(V3d(0.5, -0.04, 0.1), V3d(w - 1.75, 0.05, 0.55), 0.03);
        for (const double x : {0.25, w - 1.7, w - 0.45}) {
            accent.box(V3d(x, -0.08, 0.0), V3d(x + 0.2, 0.03, 3.0), 0.02);
        }
        for (int i = 0; i < 2; ++i) {
            trim.ellipsoid(V3d(w * (0.3 + 0.4 * i), -0.42, 3.62), V3d(0.1, 0.1, 0.07), 8);
            iron.tube({{V3d(w * (0.3 + 0.4 * i), 0.0, 3.6), 0.02},
                       {V3d(w * (0.3 + 0.4 * i), -0.4, 3.7), 0.02}},
                      6);
        }
        add_awning(0.35, w - 0.35);
    }

    // Stripes of cloth, by turns of the accent's colour and white.
    void add_awning(double from, double to) {
        const int stripes = 2 * static_cast<int>((to - from) / 0.7) + 1;
        for (int i = 0; i < stripes; ++i) {
            const double a = from + (to - from) * i / stripes;
            const double b = from + (to - from) * (i + 1) / stripes;
            MeshBuilder& cloth = i % 2 == 0 ? accent : frames;
            cloth.quad(V3d(a, -1.5, 2.45), V3d(b, -1.5, 2.45), V3d(b, -0.12, 3.02),
                       V3d(a, -0.12, 3.02));
            cloth.quad(V3d(a, -1.5, 2.2), V3d(b, -1.5, 2.2), V3d(b, -1.5, 2.45),
                       V3d(a, -1.5, 2.45));
        }
    }

    void add_arches() {
        const int bays = std::max(2, static_cast<int>(plan_.width / 2.6));
        const double pitch = plan_.width / bays;
        std::vector<Opening> openings;
        for (int i = 0; i < bays; ++i) {
            const double middle = pitch * (i + 0.5);
            openings.push_back({middle - pitch * 0.34, middle + pitch * 0.34, 0.12, 3.2, true});
        }
        add_wall(0.0, ground_height, openings);
        for (const Opening& o : openings) {
            add_window(o, 2, 3, 0.9);
            trim.box(V3d(o.from - pitch * 0.16, -0.06, 0.0), V3d(o.from, 0.02, 0.9));
            trim.box(V3d(o.to, -0.06, 0.0), V3d(o.to + pitch * 0.16, 0.02, 0.9));
        }
    }

    void add_balcony() {
        const double z = ground_height + 0.55;
        const double from = plan_.width * 0.14;
        const double to = plan_.width * 0.86;
        trim.box(V3d(from, -1.0, z), V3d(to, 0.02, z + 0.14), 0.03);
        for (const double x : {from + 0.2, to - 0.4}) {
            trim.box(V3d(x, -0.7, z - 0.3), V3d(x + 0.2, 0.02, z), 0.03);
        }
        const auto rail = [&](const V3d& a, const V3d& b) { iron.tube({{a, 0.03}, {b, 0.03}}, 6); };
        const double top = z + 1.05;
        rail(V3d(from, -0.95, top), V3d(to, -0.95, top));
        rail(V3d(from, 0.0, top), V3d(from, -0.95, top));
        rail(V3d(to, 0.0, top), V3d(to, -0.95, top));
        const int bars = static_cast<int>((to - from) / 0.16);
        for (int i = 0; i <= bars; ++i) {
            const double x = from + (to - from) * i / bars;
            iron.box(V3d(x - 0.012, -0.96, z + 0.14), V3d(x + 0.012, -0.935, top));
        }
    }

    // Side and back walls.
    void add_body() {
        const double w = plan_.width;
        sides.quad(V3d(0, depth, 0), V3d(0, 0, 0), V3d(0, 0, eaves_), V3d(0, depth, eaves_));
        sides.quad(V3d(w, 0, 0), V3d(w, depth, 0), V3d(w, depth, eaves_), V3d(w, 0, eaves_));
        sides.quad(V3d(w, depth, 0), V3d(0, depth, 0), V3d(0, depth, eaves_),
                   V3d(w, depth, eaves_));
    }

    void add_top() {
        switch (plan_.top) {
            case Top::eaves: add_eaves_roof(roof, 0.9, 0.4); break;
            case Top::mansard: add_mansard(); break;
            case Top::flat: add_parapet(); break;
            default: add_gable(); break;
        }
    }

    void add_cornice(double out) {
        const double w = plan_.width;
        trim.box(V3d(0, -out * 0.4, eaves_ - 0.4), V3d(w, 0.02, eaves_ - 0.25));
        trim.box(V3d(0, -out, eaves_ - 0.14), V3d(w, 0.05, eaves_));
        trim.box(V3d(0, -out * 0.75, eaves_ - 0.25), V3d(w, 0.03, eaves_ - 0.14));
        const int blocks = static_cast<int>(w / 0.45);
        for (int i = 0; i < blocks; ++i) {
            const double x = w * (i + 0.5) / blocks;
            trim.box(V3d(x - 0.06, -out * 0.7, eaves_ - 0.32), V3d(x + 0.06, 0.0, eaves_ - 0.2));
        }
    }

    // The ridge along the street; the slope and how far the eaves project.
    void add_eaves_roof(MeshBuilder& tiles, double slope, double out) {
        const double w = plan_.width;
        add_cornice(0.3);
        const double ridge = eaves_ + slope * depth / 2;
        const V3d a(0, -out, eaves_ - 0.02);
        const V3d b(w, -out, eaves_ - 0.02);
        const V3d c(w, depth / 2, ridge);
        const V3d d(0, depth / 2, ridge);
        tiles.quad(a, b, c, d).quad(V3d(w, depth, eaves_), V3d(0, depth, eaves_), d, c);
        sides.triangle(V3d(0, depth, eaves_), V3d(0, 0, eaves_), d);
        sides.triangle(V3d(w, 0, eaves_), V3d(w, depth, eaves_), c);
        const int dormers = std::max(1, plan_.windows - 1);
        for (int i = 0; i < dormers; ++i) {
            add_dormer(w * (i + 0.5) / dormers, 0.9, eaves_ + 0.75, tiles);
        }
    }

    void add_dormer(double middle, double y, double z, MeshBuilder& tiles) {
        const Opening o{middle - 0.42, middle + 0.42, z, z + 1.05};
        const M44d there = M44d().setTranslation(V3d(0, y, 0));
        frames.box(V3d(o.from - 0.1, y, z - 0.1), V3d(o.from, y + 2.0, z + 1.1));
        frames.box(V3d(o.to, y, z - 0.1), V3d(o.to + 0.1, y + 2.0, z + 1.1));
        frames.box(V3d(o.from, y, z - 0.1), V3d(o.to, y + 0.1, z));
        frames.box(V3d(middle - 0.03, y + 0.03, z), V3d(middle + 0.03, y + 0.1, z + 1.05));
        MeshBuilder& pane = dice(static_cast<int>(middle * 8), 9) < 0.6 ? glass : lamplight;
        pane.add(MeshBuilder().quad(V3d(o.from, 0.08, o.sill), V3d(o.to, 0.08, o.sill),
                                    V3d(o.to, 0.08, o.head), V3d(o.from, 0.08, o.head)),
                 there);
        tiles.band({{o.from - 0.22, z + 1.05}, {middle, z + 1.5}, {o.to + 0.22, z + 1.05}},
                   {{o.from - 0.22, z + 1.13}, {middle, z + 1.6}, {o.to + 0.22, z + 1.13}},
                   y - 0.15, y + 2.4);
        frames.band({{o.from - 0.1, z + 1.05}, {middle, z + 1.05}, {o.to + 0.1, z + 1.05}},
                    {{o.from - 0.1, z + 1.06}, {middle, z + 1.48}, {o.to + 0.1, z + 1.06}}, y,
                    y + 0.1);
    }

    void add_mansard() {
        const double w = plan_.width;
        add_cornice(0.38);
        const double top = eaves_ + 2.5;
        const V3d a(0, 0, eaves_);
        const V3d b(w, 0, eaves_);
        const V3d c(w, 1.0, top);
        const V3d d(0, 1.0, top);
        slate.quad(a, b, c, d);
        slate.quad(d, c, V3d(w, depth, top + 1.0), V3d(0, depth, top + 1.0));
        sides.quad(V3d(0, depth, eaves_), a, d, V3d(0, depth, top + 1.0));
        sides.quad(b, V3d(w, depth, eaves_), V3d(w, depth, top + 1.0), c);
        trim.box(V3d(0, 0.9, top - 0.06), V3d(w, 1.15, top + 0.1));
        for (int i = 0; i < plan_.windows; ++i) {
            add_dormer(w * (i + 0.5) / plan_.windows, 0.15, eaves_ + 0.45, slate);
        }
    }

    void add_parapet() {
        const double w = plan_.width;
        add_cornice(0.45);
        trim.box(V3d(0, 0.0, eaves_), V3d(w, 0.3, eaves_ + 0.85));
        trim.box(V3d(0, -0.1, eaves_ + 0.85), V3d(w, 0.35, eaves_ + 0.98));
        const int panels = std::max(2, plan_.windows);
        for (int i = 0; i <= panels; ++i) {
            const double x = std::clamp(w * i / panels, 0.2, w - 0.2);
            trim.box(V3d(x - 0.2, -0.06, eaves_), V3d(x + 0.2, 0.3, eaves_ + 1.02));
            if (i % 2 == 0) {
                trim.lathe(
                    V3d(x, 0.14, eaves_ + 1.02),
                    {{0.12, 0}, {0.07, 0.08}, {0.2, 0.3}, {0.22, 0.42}, {0.1, 0.52}, {0.0, 0.6}},
                    12);
            }
        }
        slate.quad(V3d(0, 0, eaves_), V3d(w, 0, eaves_), V3d(w, depth, eaves_),
                   V3d(0, depth, eaves_));
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
        front.band(lower, upper, 0.0, 0.35);
        trim.band(upper, capped, -0.08, 0.42);
        trim.box(V3d(0, -0.1, eaves_ - 0.12), V3d(w, 0.02, eaves_ + 0.02));
        const double ridge = eaves_ + highest * 0.8;
        const V3d a(w / 2, 0.3, ridge);
        const V3d b(w / 2, depth, ridge);
        roof.quad(V3d(0, depth, eaves_), V3d(0, 0.3, eaves_), a, b);
        roof.quad(V3d(w, 0.3, eaves_), V3d(w, depth, eaves_), b, a);
        // A round or an upright window in the gable, and a ball on its top.
        frames.box(V3d(w / 2 - 0.5, -0.03, eaves_ + 0.45), V3d(w / 2 + 0.5, 0.02, eaves_ + 1.65),
                   0.02);
        lamplight.quad(
            V3d(w / 2 - 0.4, -0.035, eaves_ + 0.55), V3d(w / 2 + 0.4, -0.035, eaves_ + 0.55),
            V3d(w / 2 + 0.4, -0.035, eaves_ + 1.55), V3d(w / 2 - 0.4, -0.035, eaves_ + 1.55));
        frames.box(V3d(w / 2 - 0.03, -0.05, eaves_ + 0.5), V3d(w / 2 + 0.03, -0.03, eaves_ + 1.6));
        trim.lathe(V3d(w / 2, 0.15, eaves_ + highest + 0.1),
                   {{0.16, 0}, {0.16, 0.12}, {0.06, 0.16}, {0.17, 0.36}, {0.12, 0.5}, {0.0, 0.56}},
                   12);
    }

    void add_chimney() {
        const double x = plan_.width * (dice(3, 3) < 0.5 ? 0.14 : 0.86);
        const double y = plan_.top == Top::flat ? 2.5 : 3.6;
        const double top = eaves_ + (plan_.top == Top::flat ? 2.2 : 4.6);
        sides.box(V3d(x - 0.45, y, eaves_ - 1.0), V3d(x + 0.45, y + 0.7, top));
        trim.box(V3d(x - 0.55, y - 0.08, top - 0.22), V3d(x + 0.55, y + 0.78, top - 0.05));
        for (const double side : {-0.22, 0.22}) {
            roof.lathe(V3d(x + side, y + 0.35, top),
                       {{0.13, 0}, {0.11, 0.45}, {0.14, 0.5}, {0.09, 0.5}}, 10);
        }
    }

    Plan plan_;
    std::uint32_t seed_;
    double eaves_;
};

}  // namespace

void add_house(SceneBuilder& builder, const Stock& stock, const std::string& name, const Plan& plan,
               const M44d& placed) {
    const House house(name, plan);
    scene::Material wall;
    wall.name = name + " front";
    wall.base_color = tint(plan.color);
    wall.base_color_texture = plan.wall == Wall::brick ? stock.brick : stock.plaster;
    wall.roughness = 0.9F;
    const MaterialIndex accent = builder.material(name + " accent", tint(plan.accent), 0.45F);
    const auto put = [&](const char* part, const MeshBuilder& built, MaterialIndex material) {
        scene::Mesh mesh = built.mesh();
        if (!mesh.triangles.empty()) {
            const std::string whole = name + " " + part;
            builder.place(whole, builder.mesh(whole, std::move(mesh), material), placed);
        }
    };
    put("front", house.front, builder.material(wall));
    put("trim", house.trim, stock.stone);
    put("frames", house.frames, stock.paint);
    put("windows", house.glass, stock.glass);
    put("curtains", house.curtain, stock.curtain);
    put("lit windows", house.lamplight, stock.lamplight);
    put("roof", house.roof, stock.clay);
    put("slates", house.slate, stock.slate);
    put("sides", house.sides, stock.sides);
    put("accent", house.accent, accent);
    put("ironwork", house.iron, stock.iron);
    put("leaves", house.leaves, stock.leaves);
    put("flowers", house.flowers, stock.flowers);
}

}  // namespace balcony::plates::street
