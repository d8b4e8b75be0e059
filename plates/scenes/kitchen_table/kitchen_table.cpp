// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/kitchen_table/kitchen_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "common/mesh_builder.hpp"
#include "common/meshes.hpp"
#include "common/scene_builder.hpp"
#include "common/solids.hpp"
#include "common/surfaces.hpp"

namespace balcony::plates {

namespace {

using scene::Color3f;
using scene::Material;
using scene::MaterialIndex;
using std::numbers::pi;

constexpr double table_depth = 0.44;  // From the middle to the front edge.
constexpr double table_width = 0.82;  // From the middle to each side.

// --------------------------------------------------------------------------------------- colours

// Planks along x, worn, ochre.
Color wood(const Sample& sample) {
    static const Gradient colors({0x5b3416, 0x8a5526, 0xb67a3a, 0xcf9a55});
    const double across = (sample.point.y + 1.0) * 2.0;
    const int plank = static_cast<int>(std::floor(across));
    const V2d in(sample.point.x * 1.1 + plank * 5.0, (across - plank) * 3.0);
    const double grain = noise(V2d(in.x, in.y * 9.0 + fractal_noise(in, 3, 4) * 4.0), 5);
    const double joint = std::min(across - plank, plank + 1.0 - across);
    return colors(0.45 + 0.3 * lattice_noise(plank, 1, 6) + 0.17 * grain) *
           (0.45 + 0.55 * smooth_step(0.0, 0.03, joint));
}

// A painted wall: patches of grey blue and ochre, laid on with a broad brush.
Color plaster(const Sample& sample) {
    static const Gradient colors({0x536a78, 0x6f8389, 0x8e9788, 0xb0a47c});
    const V2d strokes(sample.point.x * 3.0 + sample.point.y, sample.point.y * 2.0);
    return colors(0.42 + 0.3 * fractal_noise(strokes, 4, 11) +
                  0.1 * noise(V2d(sample.point.x * 26.0 + sample.point.y * 20.0,
                                  sample.point.y * 9.0 - sample.point.x * 6.0),
                              12));
}

// By height and around: a blush on a ground, with fine streaks from the stalk downwards.
Painter skin(std::uint32_t ground, std::uint32_t blush, double part, std::uint32_t seed) {
    return [=](const Sample& sample) {
        const double around = pi * sample.point.x;
        const double height = 0.5 * (sample.point.y + 1.0);
        const V2d circle(std::cos(around), std::sin(around));
        const double patch = fractal_noise(1.2 * circle + V2d(0.0, height), 3, seed);
        const double streak = noise(V2d(9.0 * around, 1.5 * height), seed + 1);
        const double amount =
            smooth_step(-0.5, 0.5, patch + 0.25 * streak + 0.8 * circle.x + 2.0 * part - 1.0);
        return mix(from_srgb(ground), from_srgb(blush), amount) * (0.9 + 0.1 * streak);
    };
}

// Osiers that cross each other.
Color wicker(const Sample& sample) {
    static const Gradient colors({0x3d2710, 0x7a5424, 0xb98b48, 0xdcb878});
    const double column = sample.point.x * 42.0;
    const double row = (sample.point.y + 1.0) * 7.0;
    const double side = std::fmod(std::floor(column) + std::floor(row) + 1000.0, 2.0);
    const double across = std::sin(pi * (column - std::floor(column)));
    const double along = std::sin(pi * (row - std::floor(row)));
    return colors(0.12 + 0.75 * std::sqrt(across * along) * (0.6 + 0.4 * side) +
                  0.1 * noise(V2d(column, row), 31));
}

// A blue-grey glaze that runs down over stoneware.
Color glaze(const Sample& sample) {
    const double height = 0.5 * (sample.point.y + 1.0);
    const double run = 0.17 + 0.05 * fractal_noise(V2d(sample.point.x * 8.0, 0.3), 3, 41);
    const Color blue =
        mix(from_srgb(0x35506b), from_srgb(0x7e9cac),
            0.5 + 0.5 * fractal_noise(V2d(sample.point.x * 4.0, height * 5.0), 4, 42));
    return mix(from_srgb(0xa9946c), blue, smooth_step(run, run + 0.02, height));
}

// ----------------------------------------------------------------------------------------- shapes

// With a dimple at both ends; `neck` draws the upper half out to a pear.
std::vector<V2d> fruit_profile(double radius, double neck) {
    std::vector<V2d> profile;
    constexpr int steps = 32;
    for (int k = 0; k <= steps; ++k) {
        const double t = pi * k / steps;  // From below.
        const double dimple = 1.0 - 0.3 * std::pow(std::abs(std::cos(t)), 9.0);
        const double upper = std::max(0.0, -std::cos(t));
        profile.emplace_back(
            k == 0 || k == steps ? 0.0 : radius * std::sin(t) * (1.0 - 0.45 * neck * upper),
            radius * (1.0 - std::cos(t) * dimple * (1.0 + 0.6 * neck * upper)));
    }
    return profile;
}

// A crumpled cloth on the table that hangs over its front edge: u to the right, v from the hem in
// front upwards and over the table to the back.
V3d cloth_point(double u, double v) {
    constexpr double hang = 0.36;    // Of its length.
    constexpr double length = 0.86;  // Metres.
    const double way = length * (v - hang);
    const V2d at(5.5 * u, 4.0 * v);
    const double fold =
        std::pow(0.5 + 0.5 * std::sin(9.0 * u + 2.2 * fractal_noise(at, 2, 51)), 2.0);
    const double crumple = 0.5 + 0.5 * fractal_noise(2.2 * at, 3, 52);
    const double border = 0.07 * fractal_noise(V2d(3.0 * u, v), 2, 53);
    const double x = -0.44 + 0.74 * u + 0.12 * (v - 0.5) + border * (1.0 - 2.0 * u) * v;
    if (way < 0.0) {
        const double drop = std::min(1.0, -way / 0.08);
        return {x, -table_depth - 0.004 - drop * (0.012 + 0.055 * fold * -way / 0.3),
                0.004 + way + 0.01 * crumple * (1.0 - drop) + 0.05 * border};
    }
    const double lies = std::min(1.0, way / 0.06) * std::min(1.0, (1.0 - v) / 0.08);
    return {x, -table_depth - 0.004 + 0.9 * way + border,
            0.004 + lies * (0.034 * fold * crumple + 0.02 * crumple * crumple)};
}

// ------------------------------------------------------------------------------------------ scene

class KitchenTable {
public:
    explicit KitchenTable(const SceneOptions& options) : builder_("kitchen_table", options) {}

    Result<scene::Scene> build() && {
        add_room();
        add_table();
        add_pots();
        add_basket();
        add_fruit();
        return std::move(builder_).finish();
    }

private:
    void put(const std::string& name, scene::Mesh mesh, MaterialIndex material,
             const M44d& placed = M44d()) {
        builder_.place(name, builder_.mesh(name, std::move(mesh), material), placed);
    }

    static M44d at(double x, double y, double z, double turn = 0.0) {
        return M44d().setEulerAngles(V3d(0.0, 0.0, turn)) * M44d().setTranslation(V3d(x, y, z));
    }

    MaterialIndex painted(const std::string& name, const Painter& painter, float roughness,
                          int width = 512, int height = 256) {
        return builder_.material(name, Color3f(1.0F), roughness,
                                 builder_.texture(name, width, height, painter));
    }

    void add_room() {
        // Upright, facing the viewer.
        const M44d upright(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1.0, 0.75, 1);
        put("wall", rectangle(6.0, 3.0), painted("wall", plaster, 0.95F, 1024, 512), upright);
        put("dado", MeshBuilder().box(V3d(-3.0, 0.955, -0.12), V3d(3.0, 1.0, -0.06), 0.012).mesh(),
            builder_.material("dado", tint(0x3c3a33), 0.7F));
        put("floor", rectangle(6.0, 4.0), builder_.material("floor", tint(0x6b4a34), 0.8F),
            at(0.0, 0.0, -0.75));
        Material window;
        window.name = "window";
        window.base_color = Color3f(0.0F);
        window.emission = Color3f(11.0F, 10.2F, 8.8F);
        put("window", rectangle(1.1, 1.5), builder_.material(window),
            M44d().setEulerAngles(V3d(0.45, 1.95, 0.0)) *
                M44d().setTranslation(V3d(-2.1, -1.2, 1.7)));
    }

    // Two halves, whose seam is behind the jar, and before it under the cloth.
    void add_table() {
        const MaterialIndex oak = painted("table", wood, 0.5F, 1024, 512);
        const auto half = [&](const std::string& name, double left, double right, double leg) {
            MeshBuilder parts;
            parts.box(V3d(left, -table_depth, -0.04), V3d(right, table_depth, 0.0), 0.006);
            parts.box(V3d(left, -table_depth + 0.06, -0.17),
                      V3d(right, -table_depth + 0.09, -0.041), 0.004);
            parts.box(V3d(leg, -table_depth + 0.05, -0.75),
                      V3d(leg + 0.07, -table_depth + 0.12, -0.041), 0.006);
            put(name, parts.mesh(), oak);
        };
        constexpr double seam = 0.02;
        half("table left", -table_width, seam, -table_width + 0.06);
        half("table right", seam, table_width, table_width - 0.13);
        Material linen;
        linen.name = "cloth";
        linen.base_color = tint(0xe9e4d8);
        linen.roughness = 0.95F;
        linen.double_sided = true;
        put("cloth", smooth_surface(220, 260, cloth_point), builder_.material(linen));
    }

    void add_pots() {
        const std::array<V2d, 18> jar{V2d(0.0, 0.0),     V2d(0.055, 0.0),   V2d(0.06, 0.004),
                                      V2d(0.074, 0.03),  V2d(0.092, 0.075), V2d(0.1, 0.12),
                                      V2d(0.097, 0.155), V2d(0.084, 0.185), V2d(0.062, 0.205),
                                      V2d(0.054, 0.214), V2d(0.054, 0.226), V2d(0.06, 0.234),
                                      V2d(0.059, 0.239), V2d(0.05, 0.239),  V2d(0.046, 0.23),
                                      V2d(0.046, 0.21),  V2d(0.06, 0.19),   V2d(0.08, 0.15)};
        put("ginger jar", lathe(jar), painted("glaze", glaze, 0.22F), at(0.02, 0.2, 0.0));
        const std::array<V2d, 16> bottle{
            V2d(0.0, 0.0),      V2d(0.036, 0.0),    V2d(0.04, 0.006),   V2d(0.041, 0.1),
            V2d(0.04, 0.2),     V2d(0.036, 0.23),   V2d(0.024, 0.262),  V2d(0.0155, 0.285),
            V2d(0.0145, 0.35),  V2d(0.0145, 0.368), V2d(0.0185, 0.37),  V2d(0.0185, 0.385),
            V2d(0.0145, 0.388), V2d(0.0105, 0.388), V2d(0.0105, 0.372), V2d(0.0105, 0.34)};
        put("bottle", lathe(bottle), builder_.material("bottle", tint(0x16241a), 0.12F),
            at(0.21, 0.25, 0.0));
        const MaterialIndex faience = builder_.material("faience", tint(0xdcd6c4), 0.25F);
        MeshBuilder jug;
        jug.lathe(
            V3d(0.0),
            {V2d(0.001, 0.0), V2d(0.05, 0.0), V2d(0.055, 0.006), V2d(0.075, 0.05), V2d(0.082, 0.09),
             V2d(0.074, 0.13), V2d(0.055, 0.17), V2d(0.051, 0.19), V2d(0.06, 0.215),
             V2d(0.056, 0.216), V2d(0.046, 0.19), V2d(0.05, 0.17), V2d(0.068, 0.13)},
            64);
        std::vector<MeshBuilder::Bead> handle;
        for (int k = 0; k <= 16; ++k) {
            const double t = pi * k / 16;
            handle.push_back(
                {V3d(-0.056 - 0.062 * std::sin(t), 0.0, 0.125 + 0.062 * std::cos(t)), 0.0085});
        }
        jug.tube(handle, 16);
        put("jug", jug.mesh(), faience, at(-0.27, 0.19, 0.0, 0.35));
        const std::array<V2d, 10> plate{V2d(0.0, 0.004),    V2d(0.07, 0.004),  V2d(0.08, 0.0),
                                        V2d(0.09, 0.003),   V2d(0.118, 0.015), V2d(0.142, 0.021),
                                        V2d(0.144, 0.0235), V2d(0.116, 0.02),  V2d(0.082, 0.0095),
                                        V2d(0.0, 0.0085)};
        put("plate", lathe(plate, 96), faience, at(-0.52, -0.1, 0.0));
    }

    void add_basket() {
        std::vector<V2d> bowl;
        for (int k = 0; k <= 16; ++k) {
            const double t = static_cast<double>(k) / 16;
            bowl.emplace_back(0.115 + 0.06 * std::pow(t, 0.8), 0.115 * t);
        }
        const MaterialIndex osier = painted("wicker", wicker, 0.7F, 1024, 128);
        Material inside;
        inside.name = "wicker inside";
        inside.base_color = tint(0x7d5829);
        inside.roughness = 0.8F;
        put("basket", lathe(bowl, 96), osier, basket_);
        for (V2d& point : bowl) {
            point.x -= 0.006;
        }
        std::reverse(bowl.begin(), bowl.end());
        bowl.emplace_back(0.0, 0.002);
        put("basket inside", lathe(bowl, 96), builder_.material(inside), basket_);
        MeshBuilder rims;
        std::vector<MeshBuilder::Bead> arch;
        for (int k = 0; k <= 40; ++k) {
            const double t = pi * k / 40;
            arch.push_back({V3d(0.172 * std::cos(t), 0.0, 0.11 + 0.2 * std::sin(t)), 0.0085});
        }
        rims.tube(arch, 16);
        for (const double lift : {0.108, 0.119}) {
            for (int k = 0; k < 48; ++k) {
                const auto bead = [&](int i) {
                    const double angle = 2.0 * pi * i / 48;
                    const double radius = 0.174 + 0.004 * std::sin(12.0 * angle + 300.0 * lift);
                    return MeshBuilder::Bead{
                        V3d(radius * std::cos(angle), radius * std::sin(angle), lift), 0.0075};
                };
                rims.tube({bead(k), bead(k + 1)}, 10);
            }
        }
        put("basket handle", rims.mesh(), builder_.material("osier", tint(0xa37a3c), 0.6F),
            basket_);
    }

    struct Fruit {
        double radius, neck;
        V3d at;
        double lean, turn;
        int kind;
    };

    void add_fruit() {
        const std::array kinds{painted("red apple", skin(0xd8a32b, 0xa8170f, 0.85, 61), 0.32F),
                               painted("yellow apple", skin(0xe0b83c, 0xc8541a, 0.35, 63), 0.34F),
                               painted("green apple", skin(0x8fa53a, 0xc99a2e, 0.3, 65), 0.34F),
                               painted("orange", skin(0xe07a12, 0xea9a24, 0.5, 67), 0.5F)};
        const MaterialIndex stalk = builder_.material("stalk", tint(0x2d1c0e), 0.8F);
        const auto put_all = [&](const std::string& name, const std::vector<Fruit>& all,
                                 const M44d& placed) {
            int number = 0;
            for (const Fruit& one : all) {
                const std::string own = fmt::format("{} {}", name, ++number);
                const M44d here = M44d().setTranslation(V3d(0, 0, -one.radius)) *
                                  M44d().setEulerAngles(V3d(one.lean, 0.0, one.turn)) *
                                  M44d().setTranslation(one.at) * placed;
                put(own, lathe(fruit_profile(one.radius, one.neck), 48),
                    kinds[static_cast<std::size_t>(one.kind)], here);
                const double top = one.radius * (1.68 + 0.62 * one.neck);
                const std::array<V3d, 3> stem{V3d(0, 0, top), V3d(0.001, 0, top + 0.009),
                                              V3d(0.005, 0.001, top + 0.019)};
                put(fmt::format("{} stalk", own), tube(stem, 0.0016, false, 10), stalk, here);
            }
        };
        put_all("basket apple",
                {{0.042, 0.0, V3d(-0.085, -0.04, 0.085), 0.3, 1.0, 0},
                 {0.043, 0.0, V3d(0.0, -0.085, 0.085), 0.5, 2.6, 1},
                 {0.041, 0.0, V3d(0.085, -0.035, 0.083), 0.2, 4.2, 0},
                 {0.042, 0.0, V3d(0.07, 0.07, 0.085), 0.3, 5.1, 2},
                 {0.043, 0.0, V3d(-0.03, 0.09, 0.085), 0.2, 0.2, 1},
                 {0.042, 0.0, V3d(-0.042, -0.02, 0.142), 0.5, 3.4, 2},
                 {0.042, 0.0, V3d(0.043, 0.005, 0.145), 0.35, 1.9, 0},
                 {0.04, 0.0, V3d(-0.01, 0.06, 0.15), 0.2, 0.9, 1}},
                basket_);
        put_all("plate fruit",
                {{0.036, 0.0, V3d(-0.045, -0.03, 0.046), 0.2, 0.5, 3},
                 {0.036, 0.0, V3d(0.035, -0.045, 0.046), 0.4, 2.5, 3},
                 {0.037, 0.0, V3d(0.045, 0.035, 0.047), 0.3, 4.0, 1},
                 {0.036, 0.0, V3d(-0.03, 0.05, 0.046), 0.1, 5.2, 3},
                 {0.035, 0.0, V3d(0.0, 0.0, 0.1), 0.3, 1.2, 0}},
                at(-0.52, -0.1, 0.0));
        put_all("apple",
                {{0.041, 0.0, V3d(-0.13, -0.14, 0.062), 0.35, 0.9, 0},
                 {0.039, 0.0, V3d(-0.04, -0.19, 0.06), 0.5, 2.2, 1},
                 {0.04, 0.0, V3d(0.06, -0.13, 0.06), 0.2, 4.4, 2},
                 {0.036, 1.0, V3d(0.16, -0.24, 0.045), 1.35, 2.0, 2},
                 {0.041, 0.0, V3d(0.27, -0.2, 0.041), 0.2, 5.6, 0},
                 {0.04, 0.0, V3d(-0.25, -0.27, 0.058), 0.3, 3.3, 3},
                 {0.039, 0.0, V3d(0.62, -0.23, 0.039), 0.3, 1.1, 1}},
                M44d());
    }

    SceneBuilder builder_;
    M44d basket_ = at(0.5, 0.06, 0.0, 0.5);
};

}  // namespace

Result<scene::Scene> make_kitchen_table(const SceneOptions& options) {
    return KitchenTable(options).build();
}

}  // namespace balcony::plates
