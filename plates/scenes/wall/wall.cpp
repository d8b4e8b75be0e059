// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/wall/wall.hpp"

#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "common/meshes.hpp"
#include "common/scene_builder.hpp"

namespace balcony::plates {

namespace {

using scene::Color3f;
using scene::Material;
using scene::MaterialIndex;
using scene::MeshIndex;
using scene::V3d;

constexpr double box_size = 2.5;
constexpr double box_chamfer = 0.16;
constexpr double cylinder_radius = 0.55;
constexpr double cylinder_centre = 0.1;  // In front of the wall pieces.
constexpr double picture_size = 14.8;
constexpr double moulding = 1.15;
constexpr double picture_front = 0.6;
constexpr double backdrop_distance = 9.0;

// What hangs in the units, row by row. Warm colours are in the middle, around the candle, and cool
// ones towards the corners.
constexpr std::array<std::array<std::string_view, wall_units>, wall_units> hung{{
    {"temple_planet", "knot_inside", "street_tram", "harbour_fisheye", "marbles_inside",
     "knot_dawn", "town_night"},
    {"plant_flower", "knot_around", "town_whirl", "checkmate", "knot_interest", "color_wheel",
     "board_planet"},
    {"marbles_inverted", "pawn_storm", "fruit_whirl", "flames", "town_parallel", "table_globe",
     "knot_flower"},
    {"knot_globe", "town_rosette", "marbles_red", "candle", "soft_rosette", "board_whirl",
     "print_gallery"},
    {"temple_sides", "apples", "letter_s", "endgame", "marbles_gold", "town_swell", "dancer"},
    {"board_swell", "board_well", "knot_bowl", "temple_flight", "town_street", "knot_droste",
     "plant_leaves"},
    {"town_tunnel", "gallery_planet", "tram_planet", "corner_zoom", "gallery_swell", "knot_day",
     "marbles_blue"},
}};

// (x, y, z) of a mesh go right along the wall, up, and towards the viewer.
M44d world_from_wall(double right, double up, double front) {
    return {0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, front, right, up, 1};
}

// A colour that varies a little, as lime plaster does.
Color plaster(const Sample& sample) {
    static const Gradient lime({0xd9cfbf, 0xe9e1d2, 0xf1eadd});
    return lime(0.5 + 0.5 * fractal_noise(sample.point * 2.5, 5, 31));
}

class Wall {
public:
    explicit Wall(const SceneOptions& options) : builder_("wall", options) {}

    Result<scene::Scene> build() && {
        if (builder_.options().pictures_and_walls) {
            add_units();
        }
        add_grid();
        add_backdrop();
        add_lights();
        return std::move(builder_).finish();
    }

private:
    MaterialIndex metal(const char* name, std::uint32_t color, float roughness) {
        Material material;
        material.name = name;
        material.base_color = tint(color);
        material.metallic = 1.0F;
        material.roughness = roughness;
        return builder_.material(material);
    }

    void add_units() {
        const auto lime = builder_.texture("plaster", 256, 256, plaster, scene::Wrap::clamp);
        const MeshIndex piece =
            builder_.mesh("wall piece", rectangle(wall_unit, wall_unit),
                          builder_.material("plaster", Color3f(1.0F), 0.95F, lime));
        const scene::Mesh moulded = picture_frame(picture_size, picture_size, moulding);
        const std::array frames{
            builder_.mesh("gold frame", moulded, metal("gold leaf", 0xd8ab58, 0.36F)),
            builder_.mesh("black frame", moulded,
                          builder_.material("black lacquer", tint(0x14110f), 0.28F)),
            builder_.mesh("walnut frame", moulded,
                          builder_.material("walnut", tint(0x4d2b18), 0.42F)),
            builder_.mesh("silver frame", moulded, metal("silver leaf", 0xbcb8ae, 0.4F))};
        const scene::Mesh sheet = rectangle(picture_size, picture_size);
        for (int row = 0; row < wall_units; ++row) {
            for (int column = 0; column < wall_units; ++column) {
                const double right = (column - wall_units / 2) * wall_unit;
                const double up = (wall_units / 2 - row) * wall_unit;
                const std::string unit = fmt::format("unit {} {}", row + 1, column + 1);
                const auto place = [&](std::string_view part, MeshIndex mesh, double front) {
                    builder_.place(fmt::format("{} {}", unit, part), mesh,
                                   world_from_wall(right, up, front));
                };
                const std::string name(hung[std::size_t(row)][std::size_t(column)]);
                Material canvas;
                canvas.name = name;
                canvas.base_color = Color3f(1.0F);
                canvas.base_color_texture.index = builder_.hung_picture(name);
                canvas.roughness = 0.7F;
                canvas.specular = 0.3F;
                const MeshIndex picture = builder_.mesh(name, sheet, builder_.material(canvas));
                place("wall", piece, 0.0);
                place("picture", picture, picture_front);
                place("frame", frames[std::size_t((row + 2 * column) % 4)], picture_front);
            }
        }
    }

    void add_grid() {
        const MeshIndex box = builder_.mesh("box", chamfered_cube(box_size, box_chamfer),
                                            builder_.material("oak", tint(0x7d4a26), 0.45F));
        const MaterialIndex brass = metal("brass", 0xc39a52, 0.3F);
        const double length = wall_unit - box_size + box_chamfer;
        const MeshIndex across =
            builder_.mesh("cylinder across", cylinder(0, length, cylinder_radius), brass);
        const MeshIndex upright =
            builder_.mesh("cylinder upright", cylinder(1, length, cylinder_radius), brass);
        constexpr double corner = -0.5 * wall_units * wall_unit;
        int number = 0;
        for (int row = 0; row <= wall_units; ++row) {
            for (int column = 0; column <= wall_units; ++column) {
                const double right = corner + column * wall_unit;
                const double up = -corner - row * wall_unit;
                builder_.place(fmt::format("box {} {}", row + 1, column + 1), box,
                               world_from_wall(right, up, 0.0));
                if (column < wall_units) {
                    builder_.place(fmt::format("cylinder {}", ++number), across,
                                   world_from_wall(right + wall_unit / 2, up, cylinder_centre));
                }
                if (row < wall_units) {
                    builder_.place(fmt::format("cylinder {}", ++number), upright,
                                   world_from_wall(right, up - wall_unit / 2, cylinder_centre));
                }
            }
        }
    }

    // A plain wall far behind, on which the grid throws its shadow.
    void add_backdrop() {
        builder_.place("backdrop",
                       builder_.mesh("backdrop", rectangle(6000, 6000),
                                     builder_.material("backdrop", tint(0x3d4c57), 0.95F)),
                       world_from_wall(0, 0, -backdrop_distance));
    }

    // A warm window high on the left, so low above the wall that cylinders throw long shadows, and
    // a cooler and weaker one on the right.
    void add_lights() {
        add_window("window", V3d(150, -210, 220), 60, Color3f(215.0F, 180.0F, 138.0F));
        add_window("far window", V3d(320, 330, 60), 160, Color3f(5.0F, 6.2F, 8.0F));
    }

    // A square that faces the middle of the wall.
    void add_window(const char* name, const V3d& at, double size, const Color3f& light) {
        Material glass;
        glass.name = name;
        glass.base_color = Color3f(0.0F);
        glass.emission = light;
        const V3d out = -at.normalized();
        const V3d right = V3d(0, 0, 1).cross(out).normalized();
        const V3d up = out.cross(right);
        builder_.place(name, builder_.mesh(name, rectangle(size, size), builder_.material(glass)),
                       M44d(right.x, right.y, right.z, 0, up.x, up.y, up.z, 0, out.x, out.y, out.z,
                            0, at.x, at.y, at.z, 1));
    }

    SceneBuilder builder_;
};

}  // namespace

Result<scene::Scene> make_wall(const SceneOptions& options) { return Wall(options).build(); }

}  // namespace balcony::plates
