// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/print_gallery/print_gallery.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "common/mesh_builder.hpp"
#include "common/meshes.hpp"
#include "scenes/print_gallery/parts.hpp"

namespace balcony::plates {

namespace print_gallery {
namespace {

using scene::Color3f;
using scene::MaterialIndex;
using scene::MeshIndex;

constexpr double near_wall = -2.6;  // Behind the eye.
constexpr double end_wall = wall_distance + 0.02;
constexpr double arcade = 2.6;
constexpr double right_wall = -2.6;
constexpr double height = 4.0;
constexpr double bay = 1.92;
constexpr int bays = 5;

// Squares of marble, one of eight by eight of which is 0.64 m wide.
Color marble_floor(const Sample& sample) {
    const V2d at = (sample.point + V2d(1.0)) * 8.0;
    const int column = static_cast<int>(std::floor(at.x));
    const int row = static_cast<int>(std::floor(at.y));
    const auto number = static_cast<std::uint32_t>(row * 16 + column);
    const V2d in(at.x - column, at.y - row);
    const double turn = 6.3 * lattice_noise(column, row, 41);
    const V2d grain(in.x * std::cos(turn) - in.y * std::sin(turn),
                    in.x * std::sin(turn) + in.y * std::cos(turn));
    const double cloud = fractal_noise(grain * 2.0 + V2d(number * 7.3), 5, 42);
    const double vein =
        std::pow(1.0 - std::fabs(fractal_noise(grain * 1.6 + V2d(number * 3.1), 5, 43)), 14.0);
    const double joint = smooth_step(0.0, 0.012, std::min({in.x, 1.0 - in.x, in.y, 1.0 - in.y}));
    static const Gradient white({0xcfc6b6, 0xe9e2d5, 0xf2ede3});
    static const Gradient red({0x5d2a20, 0x7d3a2b, 0x97503b});
    const bool is_white = ((column + row) & 1) == 0;
    const Color stone = is_white
                            ? mix(white(0.5 + 0.6 * cloud), Color(0.42, 0.4, 0.37), 0.35 * vein)
                            : mix(red(0.5 + 0.7 * cloud), Color(0.75, 0.6, 0.5), 0.3 * vein);
    return stone * (0.35 + 0.65 * joint);
}

Color plaster_of(const V2d& point) {
    const double cloud = fractal_noise(point * 3.0, 5, 51);
    return Color(0.93) * (1.0 + 0.03 * cloud);
}

Color wood(const Sample& sample) {
    static const Gradient colors({0x3c2416, 0x583520, 0x6e4529});
    const V2d p = sample.point;
    return colors(0.5 + 0.45 * noise(V2d(p.x * 1.5, p.y * 22.0), 61) +
                  0.2 * noise(V2d(p.x * 4.0, p.y * 70.0), 62));
}

struct Hung {
    const char* name;  // Of the picture in plates/pictures.
    double width;
    double height;
    bool on_end_wall;
    double along;  // Of the middle: y on the end wall, x on the right wall.
    double up;
    double mat;  // Width of the white mount; 0 is a canvas.
};

class Room {
public:
    explicit Room(const SceneOptions& options) : builder_("print_gallery", options) {}

    Result<scene::Scene> build() && {
        add_materials();
        add_shell();
        add_ceiling();
        add_arcade();
        add_print();
        add_pictures();
        add_visitor(builder_, M44d().setAxisAngle(V3d(0, 0, 1), -0.3) *
                                  M44d().setTranslation(V3d(5.2, 0.72, 0.0)));
        add_harbour(builder_);
        return std::move(builder_).finish();
    }

private:
    void add_materials() {
        const scene::TextureIndex worn = builder_.texture(
            "plaster", 256, 256, [](const Sample& s) { return plaster_of(s.point); },
            scene::Wrap::mirror);
        plaster_ = builder_.material("plaster", tint(0xb9c2ae), 0.95F, worn);
        dado_ = builder_.material("dado", tint(0x6f8273), 0.85F, worn);
        limestone_ = builder_.material("limestone", tint(0xe9dcc2), 0.8F, worn);
        scene::Material timber;
        timber.name = "walnut";
        timber.base_color_texture.index =
            builder_.texture("wood", 256, 256, wood, scene::Wrap::mirror);
        timber.base_color = Color3f(1.0F);
        timber.roughness = 0.55F;
        walnut_ = builder_.material(timber);
        scene::Material gilt;
        gilt.name = "gilt";
        gilt.base_color = tint(0xd9ae5c);
        gilt.metallic = 1.0F;
        gilt.roughness = 0.38F;
        gilt_ = builder_.material(gilt);
        ebony_ = builder_.material("ebony", tint(0x241c18), 0.35F);
        paper_ = builder_.material("paper", tint(0xf3efe6), 0.9F);
    }

    void place(const std::string& name, const MeshBuilder& solid, MaterialIndex material,
               const M44d& placed = M44d()) {
        builder_.place(name, builder_.mesh(name, solid.mesh(), material), placed);
    }

    void add_shell() {
        const double outside = arcade + 0.4;
        scene::Material stone;
        stone.name = "marble floor";
        stone.base_color = Color3f(1.0F);
        stone.base_color_texture.index =
            builder_.texture("marble floor", 768, 768, marble_floor, scene::Wrap::repeat);
        stone.roughness = 0.22F;
        constexpr double sheet = 16 * 0.64;
        builder_.place("floor",
                       builder_.mesh("floor", rectangle(sheet, sheet), builder_.material(stone)),
                       M44d().setTranslation(V3d(end_wall - sheet / 2, 0.0, 0.0)));
        constexpr double rail = 0.95;
        place("end wall",
              MeshBuilder().quad(V3d(end_wall, outside, rail), V3d(end_wall, right_wall, rail),
                                 V3d(end_wall, right_wall, height + 1),
                                 V3d(end_wall, outside, height + 1)),
              plaster_);
        place("right wall",
              MeshBuilder().quad(V3d(end_wall, right_wall, rail), V3d(near_wall, right_wall, rail),
                                 V3d(near_wall, right_wall, height + 1),
                                 V3d(end_wall, right_wall, height + 1)),
              plaster_);
        place("near wall",
              MeshBuilder().quad(V3d(near_wall, right_wall, 0), V3d(near_wall, outside, 0),
                                 V3d(near_wall, outside, height + 1),
                                 V3d(near_wall, right_wall, height + 1)),
              plaster_);
        place("dado",
              MeshBuilder()
                  .quad(V3d(end_wall, outside, 0), V3d(end_wall, right_wall, 0),
                        V3d(end_wall, right_wall, rail), V3d(end_wall, outside, rail))
                  .quad(V3d(end_wall, right_wall, 0), V3d(near_wall, right_wall, 0),
                        V3d(near_wall, right_wall, rail), V3d(end_wall, right_wall, rail)),
              dado_);
        // Skirting, rail and cornice: (height above the floor, projection from the wall,
        // thickness).
        MeshBuilder mouldings;
        constexpr std::array<std::array<double, 3>, 5> runs{{{0.0, 0.03, 0.16},
                                                             {rail - 0.04, 0.035, 0.07},
                                                             {rail + 0.03, 0.02, 0.03},
                                                             {height - 0.16, 0.06, 0.08},
                                                             {height - 0.08, 0.12, 0.09}}};
        for (const auto& [z, deep, thick] : runs) {
            mouldings.box(V3d(end_wall - deep, right_wall, z),
                          V3d(end_wall + 0.1, outside, z + thick), 0.012);
            mouldings.box(V3d(near_wall, right_wall - 0.1, z),
                          V3d(end_wall, right_wall + deep, z + thick), 0.012);
        }
        place("mouldings", mouldings, limestone_);
    }

    void add_ceiling() {
        MeshBuilder beams;
        for (int i = 0; i < 7; ++i) {
            const double x = near_wall + 0.9 + 1.42 * i;
            beams.box(V3d(x - 0.12, right_wall - 0.2, height + 0.01),
                      V3d(x + 0.12, arcade + 0.5, height + 0.3), 0.02);
        }
        for (int j = 0; j < 13; ++j) {
            const double y = right_wall + 0.1 + 0.44 * j;
            beams.box(V3d(near_wall, y - 0.05, height + 0.3), V3d(end_wall, y + 0.05, height + 0.4),
                      0.01);
        }
        beams.box(V3d(near_wall, right_wall - 0.2, height + 0.4),
                  V3d(end_wall + 0.2, arcade + 0.8, height + 0.6));
        place("ceiling", beams, walnut_);
    }

    // A bay of the arcade about x = 0: a column at its near end, a balustrade and an arch.
    static MeshBuilder arch_bay() {
        constexpr double half = bay / 2;
        constexpr double radius = half - 0.17;
        constexpr double springing = 2.5;
        constexpr double thick = 0.3;
        constexpr int steps = 24;
        std::vector<V2d> lower{{-half, springing}};
        std::vector<V2d> ring, outer;
        for (int k = 0; k <= steps; ++k) {
            const double angle = std::numbers::pi * (1.0 - double(k) / steps);
            const V2d out(std::cos(angle), std::sin(angle));
            lower.push_back(V2d(0, springing) + out * radius);
            ring.push_back(V2d(0, springing) + out * (radius - 0.002));
            outer.push_back(V2d(0, springing) + out * (radius + 0.11));
        }
        lower.emplace_back(half, springing);
        std::vector<V2d> upper;
        for (const V2d& p : lower) {
            upper.emplace_back(p.x, height + 0.6);
        }
        MeshBuilder solid;
        solid.band(lower, upper, 0.0, thick);
        solid.band(ring, outer, -0.03, thick + 0.03);
        const V3d foot(-half, thick / 2, 0.0);
        solid.box(foot + V3d(-0.2, -0.2, 0.0), foot + V3d(0.2, 0.2, 0.98), 0.012);
        solid.box(foot + V3d(-0.19, -0.19, springing - 0.1), foot + V3d(0.19, 0.19, springing),
                  0.015);
        solid.lathe(foot + V3d(0, 0, 0.98),
                    {{0.165, 0.0},
                     {0.17, 0.03},
                     {0.155, 0.06},
                     {0.14, 0.07},
                     {0.148, 0.09},
                     {0.135, 0.115},
                     {0.125, 0.12},
                     {0.125, 0.12},
                     {0.125, 0.55},
                     {0.108, 1.24},
                     {0.108, 1.24},
                     {0.122, 1.25},
                     {0.122, 1.275},
                     {0.108, 1.285},
                     {0.112, 1.32},
                     {0.135, 1.38},
                     {0.165, 1.42}},
                    32);
        solid.box(V3d(-half, 0.02, 0.0), V3d(half, thick - 0.02, 0.14), 0.012);
        solid.box(V3d(-half, 0.0, 0.84), V3d(half, thick, 0.96), 0.025);
        constexpr int balusters = 9;
        for (int i = 0; i < balusters; ++i) {
            const double x = -half + 0.2 + (bay - 0.4) * (i + 0.5) / balusters;
            solid.lathe(V3d(x, thick / 2, 0.14),
                        {{0.05, 0.0},
                         {0.05, 0.05},
                         {0.028, 0.08},
                         {0.035, 0.12},
                         {0.062, 0.22},
                         {0.055, 0.32},
                         {0.03, 0.46},
                         {0.026, 0.56},
                         {0.038, 0.6},
                         {0.05, 0.65},
                         {0.05, 0.7}},
                        14);
        }
        return solid;
    }

    void add_arcade() {
        const MeshIndex mesh = builder_.mesh("arch", arch_bay().mesh(), limestone_);
        for (int i = 0; i < bays; ++i) {
            builder_.place(fmt::format("arch {}", i + 1), mesh,
                           M44d().setTranslation(V3d(end_wall - bay * (i + 0.5), arcade, 0.0)));
        }
    }

    // A rectangle that faces z and is upright along y, on the end wall or the right wall.
    static M44d hung(bool on_end_wall, double along, double up, double off) {
        return on_end_wall
                   ? M44d(0, -1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 0, end_wall - off, along, up, 1)
                   : M44d(-1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, along, right_wall + off, up, 1);
    }

    void add_frame(const std::string& name, double width, double height_, double moulding,
                   MaterialIndex material, const M44d& placed) {
        constexpr double depth = 0.12;  // Of the mesh's own units in metres.
        builder_.place(
            name,
            builder_.mesh(name, picture_frame(width / depth, height_ / depth, moulding / depth),
                          material),
            M44d().setScale(V3d(depth)) * placed);
    }

    // Where the print is, the straight picture would be repeated: nothing of it is ever seen.
    void add_print() {
        const double width = 2 * half_width * wall_distance / picture_scale;
        const double tall = 2 * half_height * wall_distance / picture_scale;
        const double share = wall_distance * (1.0 - 1.0 / picture_scale);
        const M44d placed =
            hung(true, common_y * share, eye_height + common_z * share, end_wall - wall_distance);
        builder_.place("print", builder_.mesh("print", rectangle(width, tall), paper_), placed);
        add_frame("frame of the print", width, tall, 0.075, gilt_, placed);
    }

    void add_pictures() {
        const std::array<Hung, 11> all{{
            {"plant", 0.56, 0.7, true, 1.55, 1.97, 0.0},
            {"street_walker", 0.84, 0.56, true, -0.96, 2.06, 0.0},
            {"town_parallel", 0.42, 0.42, true, -0.72, 1.39, 0.06},
            {"plant", 0.344, 0.43, true, -1.3, 1.4, 0.06},
            {"candle", 0.62, 0.62, true, 0.2, 2.78, 0.0},
            {"both_sides", 1.1, 0.52, true, -0.98, 2.86, 0.0},
            {"town_swell", 0.6, 0.6, true, -1.98, 2.1, 0.0},
            {"plant", 0.72, 0.9, false, 5.9, 1.95, 0.1},
            {"candle_upright", 0.79, 1.1, false, 4.3, 1.95, 0.1},
            {"both_sides", 1.5, 0.71, false, 2.6, 1.95, 0.1},
            {"candle", 0.9, 0.9, false, 0.9, 1.95, 0.1},
        }};
        int number = 0;
        for (const Hung& picture : all) {
            ++number;
            const std::string name = fmt::format("picture {}", number);
            const scene::TextureIndex painted = builder_.hung_picture(picture.name);
            const M44d placed = hung(picture.on_end_wall, picture.along, picture.up, 0.02);
            builder_.place(name,
                           builder_.mesh(name, rectangle(picture.width, picture.height),
                                         builder_.material(name, Color3f(1.0F), 0.8F, painted)),
                           M44d().setTranslation(V3d(0, 0, 0.002)) * placed);
            const double width = picture.width + 2 * picture.mat;
            const double tall = picture.height + 2 * picture.mat;
            if (picture.mat > 0.0) {
                const std::string mount = fmt::format("mount {}", number);
                builder_.place(mount, builder_.mesh(mount, rectangle(width, tall), paper_), placed);
            }
            add_frame(fmt::format("frame {}", number), width, tall,
                      picture.mat > 0.0 ? 0.035 : 0.06, picture.mat > 0.0 ? ebony_ : gilt_, placed);
        }
    }

    SceneBuilder builder_;
    MaterialIndex plaster_, dado_, limestone_, walnut_, gilt_, ebony_, paper_;
};

}  // namespace
}  // namespace print_gallery

Result<scene::Scene> make_print_gallery(const SceneOptions& options) {
    return print_gallery::Room(options).build();
}

}  // namespace balcony::plates
