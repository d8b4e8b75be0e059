// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "common/mesh_builder.hpp"
#include "common/meshes.hpp"
#include "scenes/print_gallery/parts.hpp"

namespace balcony::plates::print_gallery {

namespace {

using scene::Color3f;
using scene::MaterialIndex;
using scene::MeshIndex;

constexpr double sea_level = -16.0;

// One window with shutters on a wall of 3 by 3 metres.
Color house_wall(const Sample& sample) {
    const V2d p = sample.point;
    const double worn = 0.93 + 0.07 * fractal_noise(p * 4.0, 3, 31);
    const bool in_height = p.y > -0.45 && p.y < 0.5;
    if (in_height && std::fabs(p.x) < 0.3) {
        const bool bar = std::fabs(p.x) < 0.03 || std::fabs(p.y - 0.1) < 0.03;
        return bar ? Color(0.75) : Color(0.05, 0.06, 0.075);
    }
    if (in_height && std::fabs(p.x) < 0.58) {
        return Color(0.16, 0.27, 0.24);
    }
    return p.y > -0.53 && p.y < -0.45 && std::fabs(p.x) < 0.4 ? Color(0.9) : Color(worn);
}

// Hipped roof over the unit square, eaves included.
MeshBuilder hipped_roof() {
    constexpr double e = 0.54;
    const std::array<V3d, 4> eaves{V3d(-e, -e, 0), V3d(e, -e, 0), V3d(e, e, 0), V3d(-e, e, 0)};
    const V3d left(-0.2, 0.0, 0.3);
    const V3d right(0.2, 0.0, 0.3);
    return MeshBuilder()
        .quad(eaves[0], eaves[1], right, left)
        .triangle(eaves[1], eaves[2], right)
        .quad(eaves[2], eaves[3], left, right)
        .triangle(eaves[3], eaves[0], left)
        .quad(eaves[3], eaves[2], eaves[1], eaves[0]);
}

// The town's own axes: x away from the gallery, y to the left, z up from the sea.
class Harbour {
public:
    explicit Harbour(SceneBuilder& builder) : builder_(builder) {}

    void build() {
        add_sea_and_hills();
        add_town();
        add_boats();
    }

private:
    static M44d town() {
        return M44d().setAxisAngle(V3d(0, 0, 1), 0.62) *
               M44d().setTranslation(V3d(84.0, 66.0, sea_level));
    }

    // How high the ground is behind the quay.
    static double ground(double away, double left) {
        return 1.2 + away * 0.5 * std::exp(-std::pow((left - 6.0) / 48.0, 2.0));
    }

    void add_sea_and_hills() {
        scene::Material water;
        water.name = "sea";
        water.base_color = tint(0x1d5566);
        water.roughness = 0.22F;
        builder_.place("sea", builder_.mesh("sea", rectangle(6000, 6000), builder_.material(water)),
                       M44d().setTranslation(V3d(0, 3010, sea_level)));
        const MaterialIndex grove = builder_.material("olive groves", tint(0x66704a), 1.0F);
        const MaterialIndex haze = builder_.material("far hills", tint(0x6f8796), 1.0F);
        MeshBuilder hills;
        constexpr int steps = 24;
        const auto at = [](int i, int j) {
            const double away = 6.0 * i;
            const double left = -150.0 + 300.0 * j / steps;
            const double bump = 2.5 * noise(V2d(away, left) * 0.05, 5);
            return V3d(away, left, away < 1.0 ? -2.0 : ground(away, left) - 1.0 + bump);
        };
        for (int i = 0; i < 16; ++i) {
            for (int j = 0; j < steps; ++j) {
                hills.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            }
        }
        builder_.place("hill", builder_.mesh("hill", hills.mesh(), grove), town());
        builder_.place("far hills",
                       builder_.mesh("far hills",
                                     MeshBuilder()
                                         .ellipsoid(V3d(900, 500, -10), V3d(200, 420, 95))
                                         .ellipsoid(V3d(1100, 20, -10), V3d(200, 300, 60))
                                         .mesh(),
                                     haze));
    }

    void add_town() {
        scene::TextureUse windows{.index = builder_.texture("house wall", 128, 128, house_wall),
                                  .encoding = scene::TextureEncoding::srgb};
        windows.u_axis = scene::V2f(1.0F / 3.0F, 0.0F);
        windows.v_axis = scene::V2f(0.0F, 1.0F / 3.0F);
        constexpr std::array<std::uint32_t, 6> colors{0xdfb478, 0xead3a8, 0xcf8a60,
                                                      0xd99a80, 0xefe3cc, 0xb9664f};
        // Whole windows: walls of 2 to 4 of them, 2 to 4 storeys.
        std::vector<MeshIndex> houses;
        for (std::size_t i = 0; i < colors.size(); ++i) {
            scene::Material wall;
            wall.name = fmt::format("house wall {}", i + 1);
            wall.base_color = tint(colors[i]);
            wall.base_color_texture = windows;
            const double half = 3.0 + 1.5 * static_cast<double>(i % 3);
            houses.push_back(builder_.mesh(
                fmt::format("house {}", i + 1),
                MeshBuilder()
                    .box(V3d(-half, -half, -12.0), V3d(half, half, 6.0 + 3.0 * double(i % 2)))
                    .mesh(),
                builder_.material(wall)));
        }
        const MeshIndex roof = builder_.mesh("roof", hipped_roof().mesh(),
                                             builder_.material("tiles", tint(0xa8563a), 0.9F));
        int number = 0;
        for (int row = 0; row < 9; ++row) {
            for (int column = -8; column <= 9; ++column) {
                const double dice = lattice_noise(column, row, 3);
                const double away = 5.0 + 9.5 * row + 3.0 * lattice_noise(column, row, 4);
                const double left = 9.6 * column + 4.0 * lattice_noise(column, row, 6);
                if (std::fabs(left - 6.0) > 64.0 - 4.0 * row + 20.0 * dice) {
                    continue;
                }
                const std::size_t kind = static_cast<std::size_t>(dice * 97.0) % houses.size();
                const double half = 3.0 + 1.5 * static_cast<double>(kind % 3);
                const double turn = 0.5 * (lattice_noise(column, row, 7) - 0.5);
                const M44d placed =
                    M44d().setAxisAngle(V3d(0, 0, 1), turn) *
                    M44d().setTranslation(V3d(away, left, ground(away, left) + 3.0 * dice)) *
                    town();
                ++number;
                builder_.place(fmt::format("house {}", number), houses[kind], placed);
                const double top = 6.0 + 3.0 * static_cast<double>(kind % 2);
                builder_.place(fmt::format("roof {}", number), roof,
                               M44d().setScale(V3d(2 * half)) *
                                   M44d().setTranslation(V3d(0, 0, top)) * placed);
            }
        }
        const MaterialIndex stone = builder_.material("campanile", tint(0xdcc9a4), 0.9F);
        builder_.place(
            "campanile",
            builder_.mesh("campanile",
                          MeshBuilder()
                              .box(V3d(-2.6, -2.6, 0), V3d(2.6, 2.6, 27), 0.1)
                              .box(V3d(-3, -3, 27), V3d(3, 3, 28), 0.2)
                              .box(V3d(-2.2, -2.2, 28), V3d(2.2, 2.2, 33), 0.1)
                              .box(V3d(-2.6, -2.6, 33), V3d(2.6, 2.6, 33.6), 0.2)
                              .lathe(V3d(0, 0, 33.6), {{2.4, 0}, {1.2, 3.4}, {0.0, 8.0}}, 4)
                              .mesh(),
                          stone),
            M44d().setTranslation(V3d(34, 16, ground(34, 16))) * town());
        builder_.place(
            "quay",
            builder_.mesh(
                "quay", MeshBuilder().box(V3d(-4, -150, -4), V3d(6, 150, 1.2), 0.1).mesh(), stone),
            town());
    }

    void add_boats() {
        const MeshIndex hull = builder_.mesh(
            "hull", MeshBuilder().ellipsoid(V3d(0, 0, 0.5), V3d(5.0, 1.3, 1.1)).mesh(),
            builder_.material("white paint", tint(0xf4f1ea), 0.4F));
        scene::Material canvas;
        canvas.name = "sail";
        canvas.base_color = tint(0xf0e2c8);
        const MeshIndex sail =
            builder_.mesh("sail",
                          MeshBuilder()
                              .triangle(V3d(-4, 0, 2.6), V3d(0.3, 0, 2.4), V3d(0.3, 0.2, 13))
                              .triangle(V3d(0.6, 0, 2.4), V3d(4.6, 0, 2.0), V3d(0.6, 0.3, 12))
                              .tube({{V3d(0.45, 0, 0), 0.1}, {V3d(0.45, 0, 13.4), 0.07}}, 8)
                              .mesh(),
                          builder_.material(canvas));
        constexpr std::array<std::array<double, 4>, 7> boats{{{-26, 8, 0.4, 1.0},
                                                              {-14, 30, -0.7, 0.8},
                                                              {-12, -14, 1.1, 0.9},
                                                              {-33, 26, 2.0, 0.7},
                                                              {-18, -38, 0.2, 1.1},
                                                              {-9, 12, 0.0, 0.7},
                                                              {-40, -8, -0.4, 0.8}}};
        int number = 0;
        for (const auto& [away, left, turn, size] : boats) {
            const M44d placed = M44d().setScale(V3d(size)) *
                                M44d().setAxisAngle(V3d(0, 0, 1), turn) *
                                M44d().setTranslation(V3d(away, left, 0.0)) * town();
            ++number;
            builder_.place(fmt::format("boat {}", number), hull, placed);
            builder_.place(fmt::format("sail {}", number), sail, placed);
        }
    }

    SceneBuilder& builder_;
};

}  // namespace

void add_harbour(SceneBuilder& builder) { Harbour(builder).build(); }

}  // namespace balcony::plates::print_gallery
