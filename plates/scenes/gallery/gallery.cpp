// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/gallery/gallery.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/meshes.hpp"
#include "common/scene_builder.hpp"

namespace balcony::plates {

namespace {

using scene::Color3f;
using scene::Light;
using scene::Material;
using scene::MaterialIndex;
using scene::MeshIndex;
using scene::Scene;
using scene::TextureIndex;

// The grid has a column in every corner of the room and a row along floor and ceiling.
constexpr int steps_x = 14;
constexpr int steps_y = 8;
constexpr int steps_z = 7;
constexpr double pitch_x = 2.0 * room_half_x / steps_x;
constexpr double pitch_y = 2.0 * room_half_y / steps_y;
constexpr double pitch_z = 2.0 * room_half_z / steps_z;
constexpr double cylinder_radius = 0.35;
constexpr double box_chamfer = 0.14;
constexpr double spot_distance = 24.0;  // Of the spot lights from their walls.
constexpr double max_width_lit = 26.0;  // By one of them.

// The squares of a parquet: four planks each, laid by turns along and across. One tile of it is
// four squares wide and high and fits its own copies.
Color parquet(const Sample& sample) {
    static const Gradient wood({0x4a2a1c, 0x5e3823, 0x6d432a});
    const V2d at = (sample.point + V2d(1.0)) * 2.0;
    const int column = int(std::floor(at.x));
    const int row = int(std::floor(at.y));
    V2d in(at.x - column, at.y - row);
    if (((column + row) & 1) != 0) {
        std::swap(in.x, in.y);
    }
    const int plank = int(std::floor(in.y * 4.0));
    const int number = (row * 4 + column) * 4 + plank;
    const double shade = lattice_noise(number, 0, 17);
    const double grain = noise(V2d(in.x * 3.0 + number * 9.0, in.y * 90.0), 18);
    const double to_joint =
        std::min({in.x, 1.0 - in.x, in.y * 4.0 - plank, plank + 1 - in.y * 4.0});
    return wood(shade + 0.14 * grain) * (0.45 + 0.55 * smooth_step(0.0, 0.035, to_joint));
}

// Something that faces down, from its middle.
M44d upside_down(const V3d& middle) {
    return {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, middle.x, middle.y, middle.z, 1};
}

class Gallery {
public:
    explicit Gallery(const SceneOptions& options) : builder_("gallery", options) {}

    Result<Scene> build() && {
        if (builder_.options().pictures_and_walls) {
            add_shell();
            int number = 0;
            for (const Hanging& hanging : hangings()) {
                add_hanging(hanging, ++number);
            }
            add_skylight();
        }
        add_grid();
        int number = 0;
        for (const Hanging& hanging : hangings()) {
            add_spots(hanging, ++number);
        }
        return std::move(builder_).finish();
    }

private:
    // Walls, floor and ceiling.
    void add_shell() {
        const MaterialIndex plaster = builder_.material("plaster", tint(0xdccdb4), 0.95F);
        const MeshIndex long_wall =
            builder_.mesh("long wall", rectangle(2 * room_half_x, 2 * room_half_z), plaster);
        const MeshIndex short_wall =
            builder_.mesh("short wall", rectangle(2 * room_half_y, 2 * room_half_z), plaster);
        builder_.place("wall +y", long_wall, room_from_wall(Wall::y_plus));
        builder_.place("wall +x", short_wall, room_from_wall(Wall::x_plus));
        builder_.place("wall -y", long_wall, room_from_wall(Wall::y_minus));
        builder_.place("wall -x", short_wall, room_from_wall(Wall::x_minus));

        constexpr int parquet_pixels = 320;
        const TextureIndex wood =
            builder_.texture("parquet", parquet_pixels, parquet_pixels, parquet);
        Material waxed;
        waxed.name = "parquet";
        waxed.base_color = Color3f(1.0F);
        waxed.base_color_texture.index = wood;
        waxed.roughness = 0.5F;
        waxed.clearcoat = 0.6F;
        waxed.clearcoat_roughness = 0.2F;
        const MaterialIndex boards = builder_.material(waxed);
        const MeshIndex floor = builder_.mesh(
            "floor", rectangle(2 * room_half_x, 2 * room_half_y, steps_x / 2.0, steps_y / 2.0),
            boards);
        builder_.place("floor", floor, M44d().setTranslation(V3d(0, 0, -room_half_z)));

        const MaterialIndex white = builder_.material("ceiling", tint(0xdfd9cd), 0.95F);
        const MeshIndex ceiling =
            builder_.mesh("ceiling", rectangle(2 * room_half_x, 2 * room_half_y), white);
        builder_.place("ceiling", ceiling, upside_down(V3d(0, 0, room_half_z)));
    }

    void add_hanging(const Hanging& hanging, int number) {
        const std::string picture = fmt::format("picture {}", number);
        const std::string frame = fmt::format("frame {}", number);
        const MaterialIndex canvas =
            builder_.material(picture, Color3f(1.0F), 0.7F, builder_.hung_picture(hanging.name));
        const MaterialIndex moulding = number % 2 == 0
                                           ? builder_.material(frame, tint(0x3a2a22), 0.5F)
                                           : builder_.material(frame, tint(0xc79a45), 0.4F);
        const M44d placed = M44d().setTranslation(V3d(hanging.right, hanging.up, picture_offset)) *
                            room_from_wall(hanging.wall);
        builder_.place(picture,
                       builder_.mesh(picture, rectangle(hanging.width, hanging.height), canvas),
                       placed);
        builder_.place(
            frame,
            builder_.mesh(frame, picture_frame(hanging.width, hanging.height, frame_width),
                          moulding),
            placed);
    }

    void add_grid() {
        const MaterialIndex stone = builder_.material("terracotta", tint(0xb9653f), 0.7F);
        const MaterialIndex iron = builder_.material("iron", tint(0x5a606b), 0.5F);
        box_ = builder_.mesh("box", chamfered_cube(box_size, box_chamfer), stone);
        const std::array<double, 3> pitch{pitch_x, pitch_y, pitch_z};
        for (unsigned axis = 0; axis < 3; ++axis) {
            const double length = pitch[axis] - box_size + box_chamfer;
            cylinders_[axis] =
                builder_.mesh(fmt::format("cylinder along {}", "xyz"[axis]),
                              cylinder(static_cast<int>(axis), length, cylinder_radius), iron);
        }
        for (const double side : {-1.0, 1.0}) {
            for (int i = 0; i <= steps_x; ++i) {
                add_column(-room_half_x + i * pitch_x, side * room_half_y, 0, i < steps_x);
            }
            for (int j = 0; j <= steps_y; ++j) {
                const bool goes_on = j < steps_y;
                const bool in_corner = j == 0 || j == steps_y;
                add_column(side * room_half_x, -room_half_y + j * pitch_y, 1, goes_on, !in_corner);
            }
        }
    }

    // One column of boxes with the cylinders between them, and those that go on from it along the
    // wall. In the corners, where two walls meet, only one of them brings the boxes.
    void add_column(double x, double y, unsigned along, bool goes_on, bool boxes = true) {
        const std::array<V3d, 2> half_step{V3d(pitch_x / 2, 0, 0), V3d(0, pitch_y / 2, 0)};
        for (int k = 0; k <= steps_z; ++k) {
            const V3d at(x, y, -room_half_z + k * pitch_z);
            if (boxes) {
                builder_.place(fmt::format("box {}", ++boxes_), box_, M44d().setTranslation(at));
            }
            if (boxes && k < steps_z) {
                add_cylinder(2, at + V3d(0, 0, pitch_z / 2));
            }
            if (goes_on) {
                add_cylinder(along, at + half_step[along]);
            }
        }
    }

    void add_cylinder(unsigned axis, const V3d& middle) {
        builder_.place(fmt::format("cylinder {}", ++placed_cylinders_), cylinders_[axis],
                       M44d().setTranslation(middle));
    }

    // Spot lights in the ceiling in front of a picture, two for a wide one. They aim below its
    // middle, which is farther away, and their light fades out on the wall around.
    void add_spots(const Hanging& hanging, int number) {
        const M44d placed = room_from_wall(hanging.wall);
        const int count = static_cast<int>(std::ceil(hanging.width / max_width_lit));
        for (int k = 0; k < count; ++k) {
            const double right = hanging.right + ((k + 0.5) / count - 0.5) * hanging.width;
            const V3d aim = V3d(right, hanging.up - 0.3 * hanging.height, picture_offset) * placed;
            Light spot;
            spot.name = fmt::format("spot {} {}", number, k + 1);
            spot.kind = scene::LightKind::spot;
            spot.position = V3d(right, room_half_z - 0.5, spot_distance) * placed;
            const V3d way = aim - spot.position;
            spot.direction = way.normalized();
            const double reach =
                std::hypot(hanging.width / count, hanging.height) / 2.0 / way.length();
            spot.inner_cone = static_cast<float>(std::atan(0.5 * reach));
            spot.outer_cone = static_cast<float>(std::atan(2.1 * reach));
            spot.intensity = Color3f(1.0F, 0.88F, 0.70F) * 3400.0F;
            builder_.light(spot);
        }
    }

    // A pane in the middle of the ceiling with the light of an evening sky.
    void add_skylight() {
        Material pane;
        pane.name = "skylight";
        pane.base_color = Color3f(0.0F);
        pane.emission = Color3f(3.6F, 3.9F, 4.5F);
        const MeshIndex mesh =
            builder_.mesh("skylight", rectangle(28, 18), builder_.material(pane));
        builder_.place("skylight", mesh, upside_down(V3d(0, 0, room_half_z - 0.1)));
    }

    SceneBuilder builder_;
    MeshIndex box_;
    std::array<MeshIndex, 3> cylinders_;
    int boxes_ = 0;
    int placed_cylinders_ = 0;
};

}  // namespace

M44d room_from_wall(Wall wall) {
    switch (wall) {
        case Wall::y_plus: return {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, room_half_y, 0, 1};
        case Wall::x_plus: return {0, -1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 0, room_half_x, 0, 0, 1};
        case Wall::y_minus: return {-1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, -room_half_y, 0, 1};
        case Wall::x_minus: return {0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, -room_half_x, 0, 0, 1};
    }
    return {};
}

double half_length(Wall wall) {
    return wall == Wall::y_plus || wall == Wall::y_minus ? room_half_x : room_half_y;
}

// The gaps between pictures stand before columns of the grid.
const std::array<Hanging, 7>& hangings() {
    static const std::array<Hanging, 7> all{{
        {"candle_upright", Wall::y_plus, -25.0, 0.0, 18.4, 25.6},
        {"town_parallel", Wall::y_plus, 0.0, 0.0, 24.0, 24.0},
        {"plant", Wall::y_plus, 25.0, 0.0, 18.4, 23.0},
        {"board_wide", Wall::x_plus, 0.0, 0.0, 30.0, 24.0},
        {"harbour_wide", Wall::y_minus, -14.7, 0.0, 39.0, 26.0},
        {"color_wheel", Wall::y_minus, 21.7, 0.0, 25.0, 25.0},
        {"print_gallery_wide", Wall::x_minus, 0.0, 0.0, 30.0, 22.5},
    }};
    return all;
}

Result<Scene> make_gallery(const SceneOptions& options) { return Gallery(options).build(); }

}  // namespace balcony::plates
