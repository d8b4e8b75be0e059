// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/corner/corner.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "common/meshes.hpp"
#include "common/scene_builder.hpp"
#include "common/solids.hpp"

namespace balcony::plates {

namespace {

using scene::Color3f;
using scene::Light;
using scene::Material;
using scene::MaterialIndex;

// Units of 40 cm. The walls meet at the origin; the left one runs along x, the right one along y.
constexpr double room_length = 34.0;
constexpr double room_height = 8.4;
constexpr double eye_level = 4.2;

enum class CornerWall { left, right };

// In a wall's own coordinates, x runs to the right, y upwards and z into the room.
M44d room_from_corner_wall(CornerWall wall) {
    return wall == CornerWall::left ? M44d(-1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1)
                                    : M44d(0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1);
}

struct Hung {
    const char* picture;
    CornerWall wall;
    double distance;  ///< Of the middle from the corner.
    double width, height;
    std::uint32_t frame;
};

constexpr std::array pictures{
    Hung{"temple_star", CornerWall::left, 10.45, 2.8, 3.5, 0xb08a4a},
    Hung{"street_planet", CornerWall::left, 6.45, 2.89, 3.4, 0x2b211b},
    Hung{"tondo", CornerWall::right, 6.45, 2.89, 3.4, 0x2b211b},
    Hung{"plant", CornerWall::right, 10.45, 2.8, 3.5, 0xb08a4a},
};
constexpr double frame_width = 0.28;

// Across a wall, to the right, from the corner.
double right_of(const Hung& hung) {
    return hung.wall == CornerWall::left ? -hung.distance : hung.distance;
}

Color plaster(const Sample& sample) {
    static const Gradient paint_layers({0x6d8a86, 0x779490, 0x809c98});
    return paint_layers(0.5 + 0.7 * fractal_noise(sample.point * 5.0, 5, 11));
}

// Herringbone: pairs of blocks, four times as long as wide, turned to each other.
Color herringbone(const Sample& sample) {
    static const Gradient oak({0x4c3019, 0x6a4526, 0x7f5733, 0x906641});
    constexpr int ratio = 4;
    constexpr double blocks = 8.0;
    const V2d at = (sample.point + V2d(1.0)) * (blocks / 2.0);
    const int i = static_cast<int>(std::floor(at.x));
    const int j = static_cast<int>(std::floor(at.y));
    // A cell of the lattice belongs to a lying block or a standing one by its diagonal.
    const int diagonal = ((i - j) % (2 * ratio) + 2 * ratio) % (2 * ratio);
    const bool lying = diagonal < ratio;
    const int back = lying ? diagonal : 2 * ratio - 1 - diagonal;
    const V2d start = lying ? V2d(i - back, j) : V2d(i, j - back);
    const V2d in = lying ? at - start : V2d(at.y - start.y, at.x - start.x);
    const int period = static_cast<int>(blocks);
    const auto wrapped = [&](double x) { return (static_cast<int>(x) % period + period) % period; };
    const int number = wrapped(start.x) * period + wrapped(start.y) + (lying ? 64 : 0);
    const double shade = lattice_noise(number, 0, 21);
    const double grain = fractal_noise(V2d(in.x * 1.7 + number * 5.1, in.y * 15.0), 4, 22);
    const double to_joint = std::min({in.x, ratio - in.x, in.y, 1.0 - in.y});
    return oak(0.2 + 0.6 * shade + 0.5 * grain) * (0.4 + 0.6 * smooth_step(0.0, 0.045, to_joint));
}

class CornerBuilder {
public:
    explicit CornerBuilder(const SceneOptions& options) : builder_("corner", options) {}

    Result<scene::Scene> build() {
        add_walls();
        int number = 0;
        for (const Hung& hung : pictures) {
            add_picture(hung, ++number);
        }
        add_sculpture();
        return std::move(builder_).finish();
    }

private:
    void add_walls() {
        const auto paint =
            builder_.material("plaster", Color3f(1.0F), 0.9F,
                              builder_.texture("plaster", 512, 512, plaster, scene::Wrap::mirror));
        const auto oak = builder_.material("oak", Color3f(1.0F), 0.35F,
                                           builder_.texture("oak", 1024, 1024, herringbone));
        const auto white = builder_.material("ceiling", tint(0xd8d4cb), 0.9F);
        const auto trim = builder_.material("trim", tint(0xdcd8cc), 0.5F);
        const auto wall = builder_.mesh(
            "wall", rectangle(room_length, room_height, room_length / 8.0, room_height / 8.0),
            paint);
        const auto skirting = builder_.mesh(
            "skirting board",
            moulding({{0.0, 0.62}, {0.05, 0.60}, {0.09, 0.52}, {0.13, 0.48}, {0.13, 0.0}}), trim);
        const auto cornice = builder_.mesh("cornice",
                                           moulding({{0.48, room_height},
                                                     {0.45, room_height - 0.1},
                                                     {0.33, room_height - 0.16},
                                                     {0.2, room_height - 0.27},
                                                     {0.12, room_height - 0.42},
                                                     {0.06, room_height - 0.46},
                                                     {0.0, room_height - 0.5}}),
                                           trim);
        for (const CornerWall which : {CornerWall::left, CornerWall::right}) {
            const bool left = which == CornerWall::left;
            const double side = left ? -1.0 : 1.0;
            const std::string name = left ? "left" : "right";
            const M44d middle = M44d().setTranslation(V3d(side * room_length / 2.0, 0, 0)) *
                                room_from_corner_wall(which);
            builder_.place("wall " + name, wall,
                           M44d().setTranslation(V3d(0, room_height / 2.0, 0)) * middle);
            builder_.place("skirting board " + name, skirting, middle);
            builder_.place("cornice " + name, cornice, middle);
        }
        builder_.place(
            "floor",
            builder_.mesh("floor",
                          rectangle(room_length, room_length, room_length / 4.0, room_length / 4.0),
                          oak),
            M44d().setTranslation(V3d(room_length / 2.0, room_length / 2.0, 0)));
        builder_.place("ceiling",
                       builder_.mesh("ceiling", rectangle(room_length, room_length), white),
                       M44d(1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, room_length / 2.0,
                            room_length / 2.0, room_height, 1));
    }

    // A profile (distance from the wall, height), from the top downwards, along a wall.
    static scene::Mesh moulding(const std::vector<V2d>& profile) {
        scene::Mesh mesh;
        for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
            const V2d along = (profile[k + 1] - profile[k]).normalized();
            const scene::V3f normal(V3d(0, along.x, -along.y));
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const V2d& at : {profile[k], profile[k + 1]}) {
                for (const double end : {-0.5, 0.5}) {
                    mesh.positions.emplace_back(V3d(end * room_length, at.y, at.x));
                    mesh.normals.push_back(normal);
                }
            }
            mesh.triangles.push_back({first, first + 2, first + 3});
            mesh.triangles.push_back({first, first + 3, first + 1});
        }
        return mesh;
    }

    void add_picture(const Hung& hung, int number) {
        const std::string picture = fmt::format("picture {}", number);
        const std::string frame = fmt::format("frame {}", number);
        Material print;
        print.name = picture;
        print.base_color = Color3f(1.0F);
        print.base_color_texture.index = builder_.hung_picture(hung.picture);
        print.roughness = 0.8F;
        print.specular = 0.4F;
        const auto canvas = builder_.material(print);
        Material gilded;
        gilded.name = frame;
        gilded.base_color = tint(hung.frame);
        gilded.metallic = number == 1 || number == 4 ? 1.0F : 0.0F;
        gilded.roughness = 0.42F;
        const auto moulded = builder_.material(gilded);
        // A shallow moulding, so that its shadow under the steep light stays narrow.
        const M44d placed = M44d().setScale(V3d(1, 1, 0.4)) *
                            M44d().setTranslation(V3d(right_of(hung), eye_level, 0.1)) *
                            room_from_corner_wall(hung.wall);
        builder_.place(picture, builder_.mesh(picture, rectangle(hung.width, hung.height), canvas),
                       placed);
        builder_.place(
            frame,
            builder_.mesh(frame, picture_frame(hung.width, hung.height, frame_width), moulded),
            placed);
        add_spot(fmt::format("spot {}", number),
                 V3d(right_of(hung), 7.75, 3.3) * room_from_corner_wall(hung.wall),
                 V3d(right_of(hung), eye_level - 0.15, 0.0) * room_from_corner_wall(hung.wall),
                 150.0F);
    }

    // A lamp on the ceiling, and its light.
    void add_spot(const std::string& name, const V3d& position, const V3d& target, float candela) {
        Light light;
        light.name = "light of " + name;
        light.kind = scene::LightKind::spot;
        light.direction = (target - position).normalized();
        light.position = position + light.direction * 0.2;
        light.intensity = Color3f(1.0F, 0.92F, 0.8F) * candela;
        light.inner_cone = static_cast<float>(13.0 * std::numbers::pi / 180.0);
        light.outer_cone = static_cast<float>(37.0 * std::numbers::pi / 180.0);
        builder_.light(light);
        if (!lamp_.valid()) {
            const auto black = builder_.material("lamp", tint(0x1c1c1e), 0.45F);
            lamp_ = builder_.mesh("lamp",
                                  lathe(std::vector<V2d>{{0.0, -0.3},
                                                         {0.1, -0.3},
                                                         {0.14, -0.26},
                                                         {0.16, 0.18},
                                                         {0.14, 0.18},
                                                         {0.12, 0.0}}),
                                  black);
            rod_ = builder_.mesh("rod", cylinder(2, 1.0, 0.03), black);
        }
        const V3d z = light.direction;
        const V3d x = z.cross(V3d(0, 0, 1)).normalized();
        const V3d y = z.cross(x);
        builder_.place(name, lamp_,
                       M44d(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, position.x,
                            position.y, position.z, 1));
        const double length = room_height - position.z;
        builder_.place("rod of " + name, rod_,
                       M44d().setScale(V3d(1, 1, length)) *
                           M44d().setTranslation(position + V3d(0, 0, length / 2.0)));
    }

    // A bronze knot on a plinth in the corner.
    void add_sculpture() {
        const V3d at(2.3, 2.3, 0.0);
        const M44d turned = M44d().setAxisAngle(V3d(0, 0, 1), std::numbers::pi / 4.0);
        const auto stone = builder_.material("plinth", tint(0xcfcabf), 0.8F);
        builder_.place("plinth", builder_.mesh("plinth", chamfered_cube(1.0, 0.015), stone),
                       M44d().setScale(V3d(1.25, 1.25, 2.7)) * turned *
                           M44d().setTranslation(at + V3d(0, 0, 1.35)));
        Material bronze;
        bronze.name = "bronze";
        bronze.base_color = tint(0xa8743c);
        bronze.metallic = 1.0F;
        bronze.roughness = 0.32F;
        std::vector<V3d> trefoil;
        constexpr int points = 240;
        for (int k = 0; k < points; ++k) {
            const double t = 2.0 * std::numbers::pi * k / points;
            trefoil.emplace_back(0.34 * std::sin(3.0 * t),
                                 0.34 * (std::sin(t) + 2.0 * std::sin(2.0 * t)),
                                 0.34 * (std::cos(t) - 2.0 * std::cos(2.0 * t)));
        }
        builder_.place(
            "knot", builder_.mesh("knot", tube(trefoil, 0.2, true, 28), builder_.material(bronze)),
            turned * M44d().setTranslation(at + V3d(0, 0, 3.75)));
        add_spot("spot 5", V3d(5.2, 5.2, 7.75), at + V3d(0, 0, 3.5), 60.0F);
    }

    SceneBuilder builder_;
    scene::MeshIndex lamp_{}, rod_{};
};

}  // namespace

Result<scene::Scene> make_corner(const SceneOptions& options) {
    return CornerBuilder(options).build();
}

}  // namespace balcony::plates
