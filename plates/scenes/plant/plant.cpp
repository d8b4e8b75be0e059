// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/plant/plant.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "common/meshes.hpp"
#include "common/scene_builder.hpp"
#include "common/solids.hpp"
#include "common/surfaces.hpp"
#include "scenes/plant/leaf.hpp"

namespace balcony::plates {

namespace {

using scene::Color3f;
using scene::Material;
using scene::MaterialIndex;

constexpr double soil_height = 1.62;
constexpr int leaf_count = 46;

Color terracotta(const Sample& sample) {
    const double spots = fractal_noise(sample.point * V2d(3.0, 5.0), 5, 31);
    const double lime = smooth_step(0.05, 0.5, fractal_noise(sample.point * V2d(2.0, 2.5), 4, 33));
    static const Gradient clay({0x8a4527, 0xa9592f, 0xbd6b3d});
    return mix(clay(0.5 + 0.9 * spots), from_srgb(0xcbb09a), 0.35 * lime);
}

Color soil(const Sample& sample) {
    static const Gradient earth({0x120c08, 0x2a1d13, 0x49362a});
    return earth(0.45 + 0.9 * fractal_noise(sample.point * 16.0, 4, 41));
}

// Boards along x, seen from above.
Color boards(const Sample& sample) {
    static const Gradient oak({0x5b3a20, 0x7b5230, 0x94683f, 0xa87c50});
    const double row = sample.point.y * 2.5;
    const int board = static_cast<int>(std::floor(row));
    const double in_board = row - board;
    const double warp = 0.6 * noise(V2d(sample.point.x * 1.5, row * 2.0), 51);
    const double grain = fractal_noise(
        V2d(sample.point.x * 2.2 + board * 7.3, (sample.point.y + 0.03 * warp) * 38.0), 4, 52);
    const double rings = std::sin(26.0 * (in_board + 0.35 * warp) + 5.0 * board);
    const double shade =
        0.5 + 0.18 * (lattice_noise(board, 0, 53) - 0.5) + 0.5 * grain + 0.07 * rings;
    const double joint = smooth_step(0.0, 0.02, std::min(in_board, 1.0 - in_board));
    return oak(shade) * (0.35 + 0.65 * joint);
}

Color limewash(const Sample& sample) {
    static const Gradient wash({0xb9ab98, 0xcabda9, 0xd8cdba});
    return wash(0.5 + 0.8 * fractal_noise(sample.point * V2d(3.0, 3.0), 6, 61));
}

void add_pot(SceneBuilder& builder) {
    const auto clay = builder.material("terracotta", Color3f(1.0F), 0.85F,
                                       builder.texture("terracotta", 768, 512, terracotta));
    const std::vector<V2d> pot{{0.0, 0.08},  {0.66, 0.08}, {0.7, 0.12},  {0.93, 1.36},
                               {0.94, 1.4},  {1.04, 1.4},  {1.06, 1.44}, {1.09, 1.74},
                               {1.06, 1.78}, {0.98, 1.78}, {0.95, 1.74}, {0.93, 1.5}};
    builder.place("pot", builder.mesh("pot", lathe(pot, 96), clay));
    const std::vector<V2d> saucer{{0.0, 0.0},  {0.9, 0.0},   {0.98, 0.03}, {1.12, 0.22},
                                  {1.1, 0.25}, {1.05, 0.25}, {0.95, 0.08}, {0.0, 0.06}};
    builder.place("saucer", builder.mesh("saucer", lathe(saucer, 96), clay));
    const auto earth =
        builder.material("soil", Color3f(1.0F), 1.0F, builder.texture("soil", 256, 256, soil));
    const scene::Mesh ground = smooth_surface(48, 16, [](double u, double v) {
        const double angle = 2.0 * std::numbers::pi * u;
        const double radius = 0.95 * (1.0 - v);
        const V2d at(radius * std::cos(angle), radius * std::sin(angle));
        return V3d(at.x, at.y, soil_height - 0.1 * radius + 0.09 * fractal_noise(at * 6.0, 3, 43));
    });
    builder.place("soil", builder.mesh("soil", ground, earth));
}

void add_leaves(SceneBuilder& builder) {
    const scene::TextureIndex colors = builder.texture("leaf", 384, 768, leaf_color);
    std::vector<MaterialIndex> blades;
    for (const std::uint32_t shade : {0xffffffU, 0xf3f4b4U, 0xc4dcc4U}) {
        Material blade;
        blade.name = fmt::format("leaf {}", blades.size() + 1);
        blade.base_color = tint(shade);
        blade.base_color_texture.index = colors;
        blade.roughness = 0.42F;
        blade.transmission = 0.28F;
        blades.push_back(builder.material(blade));
    }
    const auto stem = builder.material("stalk", tint(0x5b7a35), 0.5F);
    const M44d in_pot = M44d().setTranslation(V3d(0, 0, soil_height - 0.1));
    for (int number = 0; number < leaf_count; ++number) {
        const Leaf leaf = leaf_of_plant(number, leaf_count);
        const std::string name = fmt::format("leaf {}", number + 1);
        const auto which = static_cast<std::size_t>(lattice_noise(number, 0, 77) * 3.0);
        builder.place(name, builder.mesh(name, leaf_blade(leaf), blades[which]), in_pot);
        const std::string stalk = fmt::format("stalk {}", number + 1);
        builder.place(stalk, builder.mesh(stalk, leaf_stalk(leaf), stem), in_pot);
    }
}

// The camera looks along x. The window is to its left, at y = 6.
void add_room(SceneBuilder& builder) {
    const auto wood =
        builder.material("oak", Color3f(1.0F), 0.45F, builder.texture("oak", 1024, 512, boards));
    const auto wash = builder.material("limewash", Color3f(1.0F), 0.95F,
                                       builder.texture("limewash", 512, 512, limewash));
    const auto white = builder.material("window", tint(0xe8e4da), 0.6F);
    builder.place("table", builder.mesh("table", rectangle(12.0, 24.0), wood),
                  M44d(0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1));
    builder.place("wall", builder.mesh("wall", rectangle(40.0, 20.0), wash),
                  M44d(0, -1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 0, 3.6, 0, 8, 1));
    // What the sun comes through: a window with six panes between bars.
    const auto block = builder.mesh("shutter", chamfered_cube(1.0, 0.01), white);
    const auto bar = [&](const std::string& name, const V3d& from, const V3d& to) {
        builder.place(name, block,
                      M44d().setScale(to - from) * M44d().setTranslation((from + to) * 0.5));
    };
    bar("shutter low", V3d(-30, 6, -4), V3d(30, 6.3, 1.4));
    bar("shutter high", V3d(-30, 6, 9.4), V3d(30, 6.3, 30));
    bar("shutter left", V3d(-30, 6, 1.4), V3d(-6.2, 6.3, 9.4));
    bar("shutter right", V3d(0.6, 6, 1.4), V3d(30, 6.3, 9.4));
    bar("bar 1", V3d(-4.5, 6, 1.4), V3d(-4.3, 6.3, 9.4));
    bar("bar 2", V3d(-1.0, 6, 1.4), V3d(-0.8, 6.3, 9.4));
    bar("bar 3", V3d(-6.2, 6.02, 4.6), V3d(0.6, 6.28, 4.75));
    scene::Light sun;
    sun.name = "sun";
    sun.kind = scene::LightKind::directional;
    sun.direction = V3d(0.42, -0.78, -0.46).normalized();
    sun.intensity = Color3f(1.0F, 0.86F, 0.66F) * 9.0F;
    sun.angle = 0.05F;
    builder.light(sun);
}

}  // namespace

Result<scene::Scene> make_plant(const SceneOptions& options) {
    SceneBuilder builder("plant", options);
    add_pot(builder);
    add_leaves(builder);
    add_room(builder);
    return std::move(builder).finish();
}

}  // namespace balcony::plates
