// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/street/house_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace balcony::plates::street {

namespace {

using scene::MaterialIndex;

constexpr double ground_height = 3.7;
constexpr double storey_height = 3.15;
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

class House : public HouseParts {
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
        add_house_top(*this, plan_, eaves_, seed_);
        if (plan_.balcony) {
            add_balcony();
        }
    }

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
        sides.quad(V3d(0, house_depth, 0), V3d(0, 0, 0), V3d(0, 0, eaves_),
                   V3d(0, house_depth, eaves_));
        sides.quad(V3d(w, 0, 0), V3d(w, house_depth, 0), V3d(w, house_depth, eaves_),
                   V3d(w, 0, eaves_));
        sides.quad(V3d(w, house_depth, 0), V3d(0, house_depth, 0), V3d(0, house_depth, eaves_),
                   V3d(w, house_depth, eaves_));
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
