// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/gallery/gallery.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/meshes.hpp"
#include "common/scene_builder.hpp"
#include "scenes/gallery/paintings.hpp"

namespace balcony::plates {

namespace {

using scene::Color3f;
using scene::Light;
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
        }
        add_grid();
        add_lights();
        return std::move(builder_).finish();
    }

private:
    // Walls, floor and ceiling.
    void add_shell() {
        const MaterialIndex plaster = builder_.material("plaster", tint(0xf0e5d3), 0.95F);
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
        const MaterialIndex boards = builder_.material("parquet", Color3f(1.0F), 0.6F, wood);
        const MeshIndex floor = builder_.mesh(
            "floor", rectangle(2 * room_half_x, 2 * room_half_y, steps_x / 2.0, steps_y / 2.0),
            boards);
        builder_.place("floor", floor, M44d().setTranslation(V3d(0, 0, -room_half_z)));

        const MaterialIndex white = builder_.material("ceiling", tint(0xdfd9cd), 0.95F);
        const MeshIndex ceiling =
            builder_.mesh("ceiling", rectangle(2 * room_half_x, 2 * room_half_y), white);
        const M44d upside_down(1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, room_half_z, 1);
        builder_.place("ceiling", ceiling, upside_down);
    }

    void add_hanging(const Hanging& hanging, int number) {
        const std::string picture = fmt::format("picture {}", number);
        const std::string frame = fmt::format("frame {}", number);
        const TextureIndex painted = builder_.texture(
            hanging.title, hanging.pixels_x, hanging.pixels_y, hanging.painter, scene::Wrap::clamp);
        const MaterialIndex canvas = builder_.material(picture, Color3f(1.0F), 0.9F, painted);
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
        const MaterialIndex stone = builder_.material("terracotta", tint(0xb9653f), 0.85F);
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

    // Six points in a ring, slightly above the middle. Places and strengths were fitted so that the
    // light on the walls varies little: in a picture's place a white sheet would have a radiance
    // between 0.4 and 0.9, towards the corners of the room it falls to 0.2.
    void add_lights() {
        int number = 0;
        const auto add = [&](const V3d& position, float candela) {
            Light light;
            light.name = fmt::format("light {}", ++number);
            light.position = position;
            light.intensity = Color3f(1.0F, 0.965F, 0.91F) * candela;
            builder_.light(light);
        };
        for (const double x : {-1.0, 1.0}) {
            for (const double y : {-1.0, 1.0}) {
                add(V3d(31.0 * x, 11.5 * y, 5.0), 405.0F);
            }
            add(V3d(13.5 * x, 0.0, 2.5), 880.0F);
        }
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
        {"Mandelbrot set", Wall::y_plus, -25.0, 0.0, 18.4, 25.6, 690, 960, mandelbrot},
        {"Rational function", Wall::y_plus, 0.0, 0.0, 24.0, 24.0, 800, 800, rational_function},
        {"Whirlpool", Wall::y_plus, 25.0, 0.0, 18.4, 23.0, 736, 920, whirlpool},
        {"Balcony", Wall::x_plus, 0.0, 0.0, 30.0, 24.0, 960, 768, poster},
        {"Lake with red sun", Wall::y_minus, -14.7, 0.0, 39.0, 26.0, 1020, 680, woodcut},
        {"Sunflower", Wall::y_minus, 21.7, 0.0, 25.0, 25.0, 800, 800, sunflower},
        {"Spheres", Wall::x_minus, 0.0, 0.0, 30.0, 22.5, 960, 720, spheres},
    }};
    return all;
}

Result<Scene> make_gallery(const SceneOptions& options) { return Gallery(options).build(); }

}  // namespace balcony::plates
