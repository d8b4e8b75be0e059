// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/candle/candle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "common/meshes.hpp"
#include "common/scene_builder.hpp"
#include "common/solids.hpp"

namespace balcony::plates {

namespace {

using scene::Color3f;
using scene::Material;
using scene::MaterialIndex;

constexpr double dish_height = 1.1;  // Of the candle's foot above the table.
constexpr double candle_top = 8.2;
constexpr double candle_radius = 1.15;
constexpr double flame_foot = 8.75;
constexpr double flame_height = 2.5;

// Planks along x with grain, knots and dark joints. It fits its own copies along x.
Color walnut(const Sample& sample) {
    static const Gradient wood({0x20110a, 0x3d2213, 0x57331d, 0x6b4126});
    const double across = (sample.point.y + 1.0) * 2.5;
    const int plank = static_cast<int>(std::floor(across));
    const double shade = lattice_noise(plank, 3, 5);
    const V2d in(sample.point.x * 1.3 + plank * 7.0, (across - plank) * 4.0);
    const double swirl = fractal_noise(in * V2d(1.0, 1.5), 4, 21);
    const double grain = noise(V2d(in.x * 2.0, in.y * 14.0 + swirl * 7.0), 22);
    const double joint = std::min(across - plank, plank + 1.0 - across);
    return wood(0.3 + 0.4 * shade + 0.22 * grain + 0.15 * swirl) *
           (0.3 + 0.7 * smooth_step(0.0, 0.02, joint));
}

// Light that the flame leaves in the wax below it, by height: from the foot (v = 1) to the rim.
Color glow(const Sample& sample) {
    const double height = 0.5 * (sample.point.y + 1.0);
    return mix(Color(0.0), Color(1.0, 0.42, 0.10), std::pow(height, 5.0));
}

// The colours of a flame by height: blue round the wick, then white, yellow and orange.
Color flame_color(const Sample& sample) {
    static const Gradient colors(
        {0x16256e, 0x6b4630, 0xd98a2c, 0xffe0a0, 0xffc869, 0xf59a30, 0xd95f14});
    return colors(0.5 * (sample.point.y + 1.0));
}

std::vector<V2d> flame_profile() {
    std::vector<V2d> profile;
    constexpr int steps = 24;
    for (int k = 0; k <= steps; ++k) {
        const double t = static_cast<double>(k) / steps;
        // A drop: round below, drawn out above.
        const double width = 0.46 * std::pow(std::sin(std::numbers::pi * std::pow(t, 0.62)), 1.15);
        profile.emplace_back(k == 0 || k == steps ? 0.0 : width, t * flame_height);
    }
    return profile;
}

// A fruit with a dimple at both ends; `neck` draws the upper half of an apple out to a pear.
std::vector<V2d> fruit_profile(double radius, double neck) {
    std::vector<V2d> profile;
    constexpr int steps = 32;
    for (int k = 0; k <= steps; ++k) {
        const double t = std::numbers::pi * k / steps;  // From below.
        const double dimple = 1.0 - 0.32 * std::pow(std::abs(std::cos(t)), 9.0);
        const double upper = std::max(0.0, -std::cos(t));
        const double r = radius * std::sin(t) * (1.0 - 0.42 * neck * upper);
        const double z = radius * (-std::cos(t) * dimple * (1.0 + 0.55 * neck * upper));
        profile.emplace_back(k == 0 || k == steps ? 0.0 : r, z);
    }
    return profile;
}

class Candle {
public:
    Candle(SceneBuilder& builder, const M44d& placed, float light)
        : builder_(builder), placed_(placed), light_(light) {}

    void add() {
        add_holder();
        add_candle();
        add_flame();
    }

private:
    void place(std::string name, scene::MeshIndex mesh, const M44d& here = M44d()) {
        builder_.place(std::move(name), mesh, here * placed_);
    }

    void add_holder() {
        Material brass;
        brass.name = "brass";
        brass.base_color = tint(0xd9a441);
        brass.metallic = 1.0F;
        brass.roughness = 0.24F;
        const MaterialIndex metal = builder_.material(brass);
        const std::array<V2d, 14> dish{
            V2d(0, 0),      V2d(2.6, 0),   V2d(3.6, 0.35), V2d(4.2, 1.0),  V2d(4.35, 1.05),
            V2d(4.3, 1.15), V2d(4.1, 1.1), V2d(3.4, 0.5),  V2d(2.4, 0.25), V2d(1.6, 0.35),
            V2d(1.42, 0.9), V2d(1.5, 2.0), V2d(1.62, 2.1), V2d(1.2, 2.12)};
        place("holder", builder_.mesh("holder", lathe(dish), metal));
        std::vector<V3d> ring;
        for (int k = 0; k < 40; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / 40;
            ring.emplace_back(1.05 * std::cos(angle), 0.0, 1.05 * std::sin(angle));
        }
        place("handle", builder_.mesh("handle", tube(ring, 0.17, true), metal),
              M44d().setTranslation(V3d(5.2, 0, 1.3)));
    }

    void add_candle() {
        const auto light = builder_.texture("glow", 4, 256, glow, scene::Wrap::clamp);
        Material wax;
        wax.name = "wax";
        wax.base_color = tint(0xf1dfbd);
        wax.roughness = 0.45F;
        wax.emission = Color3f(0.16F * light_);
        wax.emission_texture.index = light;
        const MaterialIndex body = builder_.material(wax);
        const double r = candle_radius;
        const std::array<V2d, 6> side{V2d(r, dish_height),       V2d(r * 0.99, 5.0),
                                      V2d(r * 1.01, 7.4),        V2d(r * 0.98, candle_top - 0.12),
                                      V2d(r * 0.94, candle_top), V2d(r * 0.86, candle_top - 0.03)};
        place("candle", builder_.mesh("candle", lathe(side), body));
        wax.name = "molten wax";
        wax.emission = Color3f(0.147F, 0.073F, 0.024F) * light_;
        wax.emission_texture = {};
        wax.roughness = 0.12F;
        const MaterialIndex molten = builder_.material(wax);
        const std::array<V2d, 4> pool{V2d(r * 0.86, candle_top - 0.03),
                                      V2d(r * 0.8, candle_top - 0.2),
                                      V2d(r * 0.5, candle_top - 0.3), V2d(0, candle_top - 0.28)};
        place("pool", builder_.mesh("pool", lathe(pool), molten));
        add_drips(body);
    }

    // Wax that has run down the side: a tube that ends in a bead.
    void add_drips(MaterialIndex wax) {
        struct Drip {
            double angle, length, radius;
        };
        int number = 0;
        for (const Drip& drip : {Drip{-1.9, 3.4, 0.2}, Drip{-1.35, 1.7, 0.17},
                                 Drip{-0.7, 4.6, 0.22}, Drip{0.6, 2.2, 0.2}, Drip{2.4, 3.0, 0.2}}) {
            std::vector<V2d> bead;
            for (int k = 0; k <= 16; ++k) {
                const double t = static_cast<double>(k) / 16;
                const double thick = 0.62 + 0.38 * std::exp(-std::pow((t - 0.1) / 0.09, 2.0));
                const double ends =
                    std::sqrt(std::max(0.0, 1.0 - std::pow(std::abs(2.0 * t - 1.0), 14.0)));
                bead.emplace_back(k == 0 || k == 16 ? 0.0 : drip.radius * thick * ends,
                                  (t - 1.0) * drip.length);
            }
            scene::Mesh drop = lathe(bead, 20);
            for (std::size_t k = 0; k < drop.positions.size(); ++k) {  // It glows as the side does.
                drop.texture_coordinates[0][k].y =
                    -drop.positions[k].z / static_cast<float>(candle_top - dish_height);
            }
            const auto mesh = builder_.mesh("drip", std::move(drop), wax);
            const V3d at(candle_radius * std::cos(drip.angle), candle_radius * std::sin(drip.angle),
                         candle_top - 0.06);
            place(fmt::format("drip {}", ++number), mesh, M44d().setTranslation(at));
        }
    }

    void add_flame() {
        const std::array<V3d, 4> bent{V3d(0, 0, candle_top - 0.3), V3d(0, 0, candle_top + 0.3),
                                      V3d(0.04, 0, candle_top + 0.6),
                                      V3d(0.16, 0, candle_top + 0.85)};
        place("wick", builder_.mesh("wick", tube(bent, 0.07),
                                    builder_.material("wick", Color3f(0.01F), 1.0F)));
        Material fire;
        fire.name = "flame";
        fire.base_color = Color3f(0.0F);
        fire.specular = 0.0F;
        fire.emission = Color3f(light_);
        fire.emission_texture.index =
            builder_.texture("flame", 4, 128, flame_color, scene::Wrap::clamp);
        const auto mesh =
            builder_.mesh("flame", lathe(flame_profile(), 24), builder_.material(fire));
        M44d leaning;
        leaning.setShear(V3d(0, 0.035, 0));
        place("flame", mesh, leaning * M44d().setTranslation(V3d(0, 0, flame_foot - 0.25)));
    }

    SceneBuilder& builder_;
    M44d placed_;
    float light_;
};

class StillLife {
public:
    explicit StillLife(const SceneOptions& options) : builder_("candle", options) {}

    Result<scene::Scene> build() && {
        add_room();
        add_burning_candle(builder_, M44d(), 15.0F);
        add_fruit();
        return std::move(builder_).finish();
    }

private:
    void add_room() {
        const auto boards = builder_.texture("table", 1024, 512, walnut);
        const auto top = builder_.mesh("table", rectangle(90, 60, 2.25, 3.0),
                                       builder_.material("table", Color3f(1.0F), 0.32F, boards));
        builder_.place("table", top);
        const auto wall = builder_.mesh("wall", rectangle(240, 90),
                                        builder_.material("wall", tint(0x7a3222), 0.9F));
        builder_.place("wall", wall, M44d(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 15, 30, 1));
        // Evening light from a window high on the left, which the pictures do not show.
        Material window;
        window.name = "window";
        window.base_color = Color3f(0.0F);
        window.emission = Color3f(6.5F, 4.6F, 3.4F);
        builder_.place(
            "window", builder_.mesh("window", rectangle(14, 14), builder_.material(window)),
            M44d().setEulerAngles(V3d(0.5, 2.2, 0.0)) * M44d().setTranslation(V3d(-26, -14, 26)));
    }

    void add_fruit() {
        const auto skin = [&](const char* name, std::uint32_t color) {
            Material material;
            material.name = name;
            material.base_color = tint(color);
            material.roughness = 0.38F;
            material.clearcoat = 0.5F;
            material.clearcoat_roughness = 0.15F;
            return builder_.material(material);
        };
        const MaterialIndex stalk = builder_.material("stalk", tint(0x2d1c0e), 0.8F);
        const std::array<V3d, 4> stem{V3d(0, 0, 0), V3d(0.02, 0, 0.5), V3d(0.1, 0.03, 0.9),
                                      V3d(0.25, 0.05, 1.2)};
        const auto stem_mesh = builder_.mesh("stalk", tube(stem, 0.08), stalk);
        struct Fruit {
            const char* name;
            std::uint32_t color;
            double radius, neck;
            V3d at;
            double lean, turn;
        };
        for (const Fruit& fruit :
             {Fruit{"red apple", 0xa31712, 2.3, 0.0, {-6.2, -1.0, 2.0}, 0.12, 0.4},
              Fruit{"golden apple", 0xd39a24, 2.1, 0.0, {7.9, 1.2, 1.85}, 0.25, 2.0},
              Fruit{"green apple", 0x7c9a2c, 2.2, 0.0, {-9.6, 2.4, 1.9}, 0.1, 5.0},
              Fruit{"pear", 0xb9a432, 1.9, 1.0, {6.6, -4.4, 1.75}, 1.35, 2.7},
              Fruit{"plum", 0x3a1238, 1.2, 0.0, {-2.9, -6.0, 1.0}, 0.6, 1.0},
              Fruit{"second plum", 0x471a3d, 1.15, 0.0, {-5.5, -5.6, 0.98}, 1.0, 4.0}}) {
            M44d lean;
            lean.setEulerAngles(V3d(fruit.lean, 0, fruit.turn));
            const M44d placed = lean * M44d().setTranslation(fruit.at);
            builder_.place(fruit.name,
                           builder_.mesh(fruit.name, lathe(fruit_profile(fruit.radius, fruit.neck)),
                                         skin(fruit.name, fruit.color)),
                           placed);
            const double top = fruit.radius * (0.6 + 0.9 * fruit.neck);
            builder_.place(fmt::format("stalk of the {}", fruit.name), stem_mesh,
                           M44d().setTranslation(V3d(0, 0, top)) * placed);
        }
    }

    SceneBuilder builder_;
};

}  // namespace

void add_burning_candle(SceneBuilder& builder, const M44d& placed, float light) {
    Candle(builder, placed, light).add();
}

Result<scene::Scene> make_candle(const SceneOptions& options) { return StillLife(options).build(); }

}  // namespace balcony::plates
