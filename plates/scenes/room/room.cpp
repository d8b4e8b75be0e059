// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/room/room.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "common/meshes.hpp"
#include "common/solids.hpp"
#include "scenes/plant/leaf.hpp"
#include "scenes/room/furniture.hpp"
#include "scenes/room/painted.hpp"
#include "scenes/room/workshop.hpp"

namespace balcony::plates {

namespace room {
namespace {

using scene::Color3f;
using scene::Material;
using scene::MaterialIndex;

constexpr double half_x = 3.5;
constexpr double half_y = 2.5;
constexpr double ceiling = 2.9;

constexpr std::array window_places{-1.65, 1.65};  // x of their middles.
constexpr double window_half = 0.68;
constexpr double sill = 0.75;
constexpr double lintel = 2.45;
constexpr double wall_depth = 0.24;

class Room : Workshop {
public:
    explicit Room(const SceneOptions& options) : Workshop("room", options) {}

    Result<scene::Scene> build() && {
        add_shell();
        add_windows();
        add_fireplace_wall();
        add_sofa_wall();
        add_bookcase_wall();
        add_window_wall();
        add_lamps();
        return std::move(builder).finish();
    }

private:
    void add_shell() {
        const MaterialIndex paper = tiled("wallpaper", 160, wallpaper, 0.4, 0.9F);
        MeshBuilder walls;
        walls.quad(V3d(half_x, half_y, 0), V3d(half_x, -half_y, 0), V3d(half_x, -half_y, ceiling),
                   V3d(half_x, half_y, ceiling));
        walls.quad(V3d(-half_x, -half_y, 0), V3d(-half_x, half_y, 0), V3d(-half_x, half_y, ceiling),
                   V3d(-half_x, -half_y, ceiling));
        walls.quad(V3d(half_x, -half_y, 0), V3d(-half_x, -half_y, 0),
                   V3d(-half_x, -half_y, ceiling), V3d(half_x, -half_y, ceiling));
        // Around the windows.
        const auto strip = [&](double from, double to, double low, double high) {
            walls.quad(V3d(from, half_y, low), V3d(to, half_y, low), V3d(to, half_y, high),
                       V3d(from, half_y, high));
        };
        strip(-half_x, half_x, 0.0, sill);
        strip(-half_x, half_x, lintel, ceiling);
        strip(-half_x, window_places[0] - window_half, sill, lintel);
        strip(window_places[0] + window_half, window_places[1] - window_half, sill, lintel);
        strip(window_places[1] + window_half, half_x, sill, lintel);
        put("walls", walls, paper);

        white_ = plain("white paint", 0xefece4, 0.5F);
        put("ceiling",
            MeshBuilder().quad(V3d(-half_x, half_y, ceiling), V3d(half_x, half_y, ceiling),
                               V3d(half_x, -half_y, ceiling), V3d(-half_x, -half_y, ceiling)),
            plain("ceiling paint", 0xf4f1ea, 0.9F));
        put("floor",
            MeshBuilder().quad(V3d(-half_x, -half_y, 0), V3d(half_x, -half_y, 0),
                               V3d(half_x, half_y, 0), V3d(-half_x, half_y, 0)),
            tiled("oak boards", 512, oak_boards, 2.0, 0.38F));
        put("rug", rectangle(3.36, 2.4), painted("carpet", 840, 600, carpet, 0.95F),
            M44d().setTranslation(V3d(-0.35, -0.05, 0.006)));

        MeshBuilder trim;
        const auto along_walls = [&](double out, double low, double high, double chamfer) {
            for (const double side : {-1.0, 1.0}) {
                const double y = side * half_y;
                const double x = side * half_x;
                trim.box(V3d(-half_x, std::min(y, y - side * out), low),
                         V3d(half_x, std::max(y, y - side * out), high), chamfer);
                trim.box(V3d(std::min(x, x - side * out), -half_y, low),
                         V3d(std::max(x, x - side * out), half_y, high), chamfer);
            }
        };
        along_walls(0.018, 0.0, 0.12, 0.004);
        along_walls(0.08, ceiling - 0.04, ceiling, 0.0);
        along_walls(0.05, ceiling - 0.1, ceiling - 0.03, 0.02);
        put("skirting and cornice", trim, white_);
    }

    // Frames, and right behind them what is seen through the windows and lights the room.
    void add_windows() {
        Material outside;
        outside.name = "daylight";
        outside.base_color = Color3f(0.0F);
        outside.specular = 0.0F;
        outside.emission = Color3f(9.0F);
        outside.emission_texture.index =
            builder.texture("countryside", 416, 520, countryside, scene::Wrap::clamp);
        const MaterialIndex daylight = builder.material(outside);
        MeshBuilder frames;
        int number = 0;
        for (const double x : window_places) {
            const double low = x - window_half;
            const double high = x + window_half;
            const double back = half_y + wall_depth;
            // The reveal and a sill.
            frames.box(V3d(low - 0.02, half_y, sill - 0.04), V3d(low, back, lintel));
            frames.box(V3d(high, half_y, sill - 0.04), V3d(high + 0.02, back, lintel));
            frames.box(V3d(low, half_y, lintel), V3d(high, back, lintel + 0.02));
            frames.box(V3d(low - 0.08, half_y - 0.1, sill - 0.04), V3d(high + 0.08, back, sill),
                       0.008);
            for (const double side : {low - 0.09, high}) {
                frames.box(V3d(side, half_y - 0.03, sill), V3d(side + 0.09, half_y, lintel + 0.09),
                           0.01);
            }
            frames.box(V3d(low - 0.09, half_y - 0.03, lintel),
                       V3d(high + 0.09, half_y, lintel + 0.09), 0.01);
            // Two casements with bars.
            const double pane = half_y + 0.14;
            for (const double at : {low, x - 0.05, x, high - 0.05}) {
                frames.box(V3d(at, pane, sill), V3d(at + 0.05, pane + 0.04, lintel), 0.006);
            }
            for (const double at : {sill, 1.3, 1.87, lintel - 0.05}) {
                const double thick = at > sill && at < 2.0 ? 0.022 : 0.05;
                frames.box(V3d(low, pane, at), V3d(high, pane + 0.036, at + thick), 0.005);
            }
            put(fmt::format("daylight {}", ++number), rectangle(2.0 * window_half, lintel - sill),
                daylight, hang(V3d(x, back, (sill + lintel) / 2.0), at_wall_plus_y));
        }
        put("window frames", frames, white_);
    }

    // x = 3.5: a fireplace with a painting, a dresser to its left and a clock to its right.
    void add_fireplace_wall() {
        const M44d middle = stand(V3d(half_x, 0, 0), at_wall_plus_x);
        const Fireplace parts = fireplace(ceiling);
        put("chimney breast", parts.breast, plain("green paint", 0x4e6a5c, 0.85F), middle);
        put("fireplace", parts.surround, tiled("marble", 256, marble, 1.2, 0.25F), middle);
        put("hearth", parts.hearth, plain("soot", 0x2a2622, 0.9F), middle);
        put("logs", parts.logs, plain("bark", 0x3b2618, 0.95F), middle);
        put("flames", parts.flames, glowing("fire", Color3f(2.2F, 0.7F, 0.1F)), middle);
        brass_ = metal("brass", 0xd9a84e, 0.25F);
        gold_ = plain("gilding", 0xb98a3c, 0.35F);
        dark_wood_ = plain("mahogany", 0x5a2c1c, 0.35F);
        hang_picture("harbour_wide", V3d(half_x - breast_depth, 0, 1.86), at_wall_plus_x,
                     V2d(1.26, 0.84), gold_);
        add_candlesticks();
        const MaterialIndex teal = plain("teal glaze", 0x1f6f78, 0.15F);
        const std::vector<V2d> jar{{0.0, 0.0},   {0.05, 0.0},  {0.09, 0.05}, {0.1, 0.1},
                                   {0.07, 0.16}, {0.04, 0.19}, {0.05, 0.22}, {0.0, 0.22}};
        put("jar", plates::lathe(jar, 48), teal,
            M44d().setTranslation(V3d(half_x - 0.42, 0.05, mantel_height)));

        const Dresser chest = dresser();
        const M44d left = stand(V3d(half_x, 1.72, 0), at_wall_plus_x);
        put("dresser", chest.wood, plain("walnut", 0x7a5233, 0.4F), left);
        put("knobs", chest.knobs, brass_, left);
        hang_picture("print_gallery", V3d(half_x, 1.72, 1.85), at_wall_plus_x, V2d(0.72, 0.72),
                     dark_wood_);
        put("globe", plates::sphere(0.17), painted("globe", 512, 256, globe_map, 0.3F),
            M44d().setAxisAngle(V3d(1, 0, 0), 23.4 * degrees) *
                M44d().setTranslation(V3d(half_x - 0.24, 1.9, 1.11)));
        MeshBuilder foot;
        foot.lathe(V3d(half_x - 0.24, 1.9, 0.85),
                   {{0.1, 0.0}, {0.1, 0.015}, {0.02, 0.03}, {0.015, 0.1}, {0.0, 0.1}});
        put("foot of the globe", foot, brass_);
        put("books on the dresser", pile_of_books(3, 7), plain("book covers", 0xffffff, 0.6F),
            stand(V3d(half_x - 0.24, 1.45, 0.85), at_wall_plus_x));

        const LongcaseClock clock = longcase_clock();
        const M44d right = stand(V3d(half_x, -1.72, 0), at_wall_plus_x);
        put("clock", clock.wood, dark_wood_, right);
        put("pendulum", clock.brass, brass_, right);
        put("dial", rectangle(0.38, 0.38), painted("dial", 256, 256, clock_dial, 0.5F),
            hang(V3d(half_x - 0.185, -1.72, dial_height), at_wall_plus_x));
    }

    void add_candlesticks() {
        MeshBuilder sticks, candles;
        for (const double y : {-0.62, -0.5, 0.62}) {
            const double height = y == -0.5 ? 0.12 : 0.2;
            const V3d at(half_x - 0.42, y, mantel_height);
            sticks.lathe(at, {{0.045, 0.0},
                              {0.045, 0.01},
                              {0.012, 0.03},
                              {0.01, height - 0.03},
                              {0.022, height - 0.02},
                              {0.016, height}});
            candles.lathe(at + V3d(0, 0, height - 0.01), {{0.011, 0.0}, {0.01, 0.16}, {0.0, 0.165}},
                          12);
        }
        put("candlesticks", sticks, brass_);
        put("candles", candles, plain("wax", 0xefe3c8, 0.5F));
    }

    // x = -3.5: a sofa below three pictures, and a low table with things on it.
    void add_sofa_wall() {
        const MaterialIndex velvet = plain("blue velvet", 0x2f4f73, 0.9F);
        const M44d sofa = stand(V3d(-half_x + 0.5, 0, 0), at_wall_minus_x);
        put("sofa", upholstery(2.3, 3), velvet, sofa);
        put("feet of the sofa", feet(2.3), dark_wood_, sofa);
        const auto pillow = [&](const char* name, std::uint32_t color, double x, double roll) {
            const M44d leaning = M44d().setAxisAngle(V3d(0, 1, 0), roll * degrees) *
                                 M44d().setAxisAngle(V3d(1, 0, 0), -22 * degrees) *
                                 M44d().setTranslation(V3d(x, 0.02, 0.68)) * sofa;
            put(name, cushion(V3d(0.0), V3d(0.2, 0.07, 0.2), 3.2), plain(name, color, 0.9F),
                leaning);
        };
        pillow("red pillow", 0xb0392e, -0.72, 12.0);
        pillow("ochre pillow", 0xd19a35, 0.4, -6.0);
        pillow("white pillow", 0xe9e0cf, 0.74, -20.0);
        hang_picture("knot_day", V3d(-half_x, -0.95, 1.7), at_wall_minus_x, V2d(0.66, 0.66),
                     white_);
        hang_picture("town_street", V3d(-half_x, 0, 1.7), at_wall_minus_x, V2d(0.66, 0.66), white_);
        hang_picture("fruit_whirl", V3d(-half_x, 0.95, 1.7), at_wall_minus_x, V2d(0.66, 0.66),
                     white_);

        const MaterialIndex oak = plain("oak", 0x9a6b3f, 0.4F);
        const M44d table = stand(V3d(-1.72, 0, 0), at_wall_minus_x);
        put("coffee table", coffee_table(), oak, table);
        const MaterialIndex cloth = plain("cloth", 0xffffff, 0.6F);
        put("books on the table", pile_of_books(4, 3), cloth, stand(V3d(-1.72, 0.36, 0.42), 75.0));
        put("magazine", rectangle(0.22, 0.3), drawn("magazine", 160, 218, paint_magazine()),
            M44d().setAxisAngle(V3d(0, 0, 1), 70 * degrees) *
                M44d().setTranslation(V3d(-1.68, -0.36, 0.424)));
        const std::vector<V2d> vase{{0.0, 0.0},    {0.05, 0.0},   {0.055, 0.01}, {0.09, 0.08},
                                    {0.1, 0.14},   {0.085, 0.2},  {0.045, 0.26}, {0.036, 0.3},
                                    {0.045, 0.33}, {0.06, 0.345}, {0.05, 0.34},  {0.03, 0.3}};
        put("vase", plates::lathe(vase, 64),
            painted(
                "vase", 448, 320,
                [](const Sample& sample) {
                    const double turn = 24.0 * sample.point.x / 1.4;
                    const double y = sample.point.y;
                    const double wave = 0.12 * std::sin(std::numbers::pi * turn / 2.0);
                    const bool dark = std::abs(y + 0.1 - wave) < 0.05 ||
                                      std::abs(y + 0.42) < 0.03 || std::abs(y - 0.3) < 0.03 ||
                                      y < -0.85;
                    return dark ? from_srgb(0x1f3a6b) : from_srgb(0xe8e4d8);
                },
                0.2F),
            M44d().setTranslation(V3d(-1.72, 0.0, 0.42)));
    }

    // y = -2.5: a bookcase, a poster and the door.
    void add_bookcase_wall() {
        const M44d placed = stand(V3d(1.2, -half_y, 0), at_wall_minus_y);
        put("bookcase", bookcase(), plain("bookcase", 0x6e4a2e, 0.5F), placed);
        put("books", books(), plain("bindings", 0xffffff, 0.6F), placed);
        const M44d poster = hang(V3d(-0.85, -half_y, 1.62), at_wall_minus_y);
        put("poster", rectangle(0.8, 1.15), drawn("poster", 448, 644, paint_poster()),
            M44d().setTranslation(V3d(0, 0, 0.012)) * poster);
        put_frame("frame of the poster", V2d(0.8, 1.15), 0.03,
                  plain("black lacquer", 0x1c1a19, 0.35F), poster);
        const Door parts = door();
        const M44d entrance = stand(V3d(-2.45, -half_y, 0), at_wall_minus_y);
        put("door", parts.leaf, plain("door paint", 0xa8432f, 0.45F), entrance);
        put("door handle", parts.handle, brass_, entrance);
    }

    // y = 2.5: below the windows a table with chairs and an armchair, between them a plant.
    void add_window_wall() {
        const MaterialIndex fabric = plain("curtains", 0xb5652f, 0.9F);
        MeshBuilder rods;
        int number = 0;
        for (const double x : window_places) {
            for (const double side : {-1.0, 1.0}) {
                put(fmt::format("curtain {}", ++number), curtain(0.46, 2.5), fabric,
                    M44d().setTranslation(
                        V3d(x + side * (window_half + 0.2), half_y - 0.12, 2.62)));
            }
            rods.tube({{V3d(x - 1.2, half_y - 0.12, 2.63), 0.014},
                       {V3d(x + 1.2, half_y - 0.12, 2.63), 0.014}});
            for (const double side : {-1.2, 1.2}) {
                rods.ellipsoid(V3d(x + side, half_y - 0.12, 2.63), V3d(0.03), 12);
            }
        }
        put("curtain rods", rods, brass_);

        const V3d table(1.65, 1.5, 0.0);
        const MaterialIndex beech = plain("beech", 0xc59a63, 0.4F);
        put("table", round_table(), beech, stand(table, 0.0));
        put("chair 1", chair(), beech, stand(table + V3d(-0.68, -0.05, 0), 82.0));
        put("chair 2", chair(), beech, stand(table + V3d(0.1, -0.66, 0), 172.0));
        add_breakfast(table + V3d(0, 0, 0.74));

        const M44d armchair = stand(V3d(-1.85, 1.72, 0), 28.0);
        put("armchair", upholstery(0.95, 1), plain("rust wool", 0xa4532f, 0.9F), armchair);
        put("feet of the armchair", feet(0.95), dark_wood_, armchair);
        put("pillow", cushion(V3d(0, 0.03, 0.66), V3d(0.19, 0.07, 0.17), 3.0),
            plain("green pillow", 0x5d7a4a, 0.9F), armchair);
        add_plant(V3d(0.0, 1.75, 0.0));
    }

    void add_breakfast(const V3d& at) {
        const std::vector<V2d> bowl{{0.0, 0.0},   {0.06, 0.0},   {0.07, 0.012}, {0.12, 0.05},
                                    {0.15, 0.09}, {0.145, 0.09}, {0.11, 0.05},  {0.0, 0.03}};
        const MaterialIndex china = plain("china", 0xeef0f0, 0.15F);
        put("bowl", plates::lathe(bowl, 48), china, M44d().setTranslation(at));
        struct Fruit {
            V3d at;
            double radius;
            std::uint32_t color;
        };
        int number = 0;
        for (const Fruit& fruit : {Fruit{V3d(0.05, 0.02, 0.09), 0.045, 0xb8231c},
                                   Fruit{V3d(-0.05, 0.04, 0.09), 0.042, 0xe08a1e},
                                   Fruit{V3d(-0.01, -0.06, 0.09), 0.044, 0x86a83a},
                                   Fruit{V3d(0.0, 0.0, 0.15), 0.042, 0xe6a02a}}) {
            const std::string name = fmt::format("fruit {}", ++number);
            put(name, plates::sphere(fruit.radius, 24), plain(name, fruit.color, 0.4F),
                M44d().setTranslation(at + fruit.at));
        }
        const std::vector<V2d> cup{{0.0, 0.0},    {0.055, 0.0},  {0.08, 0.012},
                                   {0.03, 0.012}, {0.025, 0.02}, {0.036, 0.05},
                                   {0.04, 0.085}, {0.036, 0.08}, {0.0, 0.03}};
        for (const V3d& place : {V3d(-0.3, -0.08, 0), V3d(0.04, -0.3, 0)}) {
            put(fmt::format("cup {}", ++number), plates::lathe(cup, 32), china,
                M44d().setTranslation(at + place));
        }
    }

    void add_plant(const V3d& at) {
        const std::vector<V2d> pot{{0.0, 0.0},   {0.17, 0.0}, {0.18, 0.02},
                                   {0.23, 0.4},  {0.25, 0.4}, {0.25, 0.46},
                                   {0.22, 0.46}, {0.21, 0.4}, {0.0, 0.4}};
        put("pot", plates::lathe(pot, 48), plain("terracotta", 0xb5623c, 0.85F),
            M44d().setTranslation(at));
        Material blade;
        blade.name = "leaves";
        blade.base_color = Color3f(1.0F);
        blade.base_color_texture.index = builder.texture("leaf", 128, 256, leaf_color);
        blade.roughness = 0.45F;
        const MaterialIndex green = builder.material(blade);
        const MaterialIndex stem = plain("stalks", 0x5b7a35, 0.5F);
        constexpr int count = 30;
        scene::Mesh blades, stalks;
        for (int k = 0; k < count; ++k) {
            const Leaf leaf = leaf_of_plant(k, count);
            append(blades, leaf_blade(leaf));
            append(stalks, leaf_stalk(leaf));
        }
        const M44d in_pot = M44d().setScale(0.25) * M44d().setTranslation(at + V3d(0, 0, 0.38));
        put("plant", std::move(blades), green, in_pot);
        put("stalks of the plant", std::move(stalks), stem, in_pot);
    }

    // A pendant above the table, a floor lamp beside the sofa, and spot lights in the ceiling.
    void add_lamps() {
        const Color3f warm(1.0F, 0.88F, 0.72F);
        const Lamp hanging = pendant();
        const M44d above = M44d().setTranslation(V3d(1.65, 1.5, ceiling));
        put("pendant", hanging.metal, brass_, above);
        put("globe of the pendant", hanging.shade, glowing("opal glass", warm * 9.0F), above);
        const Lamp standing = floor_lamp();
        const V3d corner(-3.02, 1.78, 0);
        put("floor lamp", standing.metal, brass_, M44d().setTranslation(corner));
        put("lampshade", standing.shade, glowing("lampshade", Color3f(2.0F, 1.4F, 0.8F)),
            M44d().setTranslation(corner));
        add_light("floor lamp", corner + V3d(0, 0, 1.55), warm * 3.0F, {});

        // What a photographer would add, so that the ceiling is not lit by reflections alone.
        add_light("fill", V3d(0, 0, 1.3), Color3f(2.8F), {});

        MeshBuilder rings, discs;
        for (const double x : {-2.2, 0.0, 2.2}) {
            for (const double y : {-1.35, 1.35}) {
                const V3d at(x, y, ceiling);
                rings.lathe(at - V3d(0, 0, 0.012), {{0.045, 0.0}, {0.06, 0.0}, {0.065, 0.012}});
                discs.lathe(at - V3d(0, 0, 0.006), {{0.0, 0.0}, {0.045, 0.0}});
                add_light("spot", at - V3d(0, 0, 0.02), warm * 5.0F, 85.0 * degrees);
            }
        }
        put("rings of the spot lights", rings, brass_);
        put("spot lights", discs, glowing("spot lights", warm * 6.0F));
        // Stucco in the middle of the ceiling.
        MeshBuilder rose;
        rose.lathe(V3d(0, 0, ceiling - 0.05),
                   {{0.0, 0.0},
                    {0.05, 0.0},
                    {0.09, 0.03},
                    {0.16, 0.02},
                    {0.2, 0.035},
                    {0.36, 0.03},
                    {0.4, 0.015},
                    {0.44, 0.05}},
                   64);
        for (int k = 0; k < 16; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / 16;
            rose.ellipsoid(V3d(0.28 * std::cos(angle), 0.28 * std::sin(angle), ceiling - 0.02),
                           V3d(0.035, 0.035, 0.02), 12);
        }
        put("ceiling rose", rose, white_);
    }

    // A light at a point, which shines in all directions or, within a cone, downwards.
    void add_light(const char* name, const V3d& at, const Color3f& intensity,
                   std::optional<double> cone) {
        scene::Light light;
        light.name = name;
        light.kind = cone ? scene::LightKind::spot : scene::LightKind::point;
        light.position = at;
        light.intensity = intensity;
        if (cone) {
            light.outer_cone = static_cast<float>(*cone);
            light.inner_cone = static_cast<float>(0.4 * *cone);
        }
        builder.light(light);
    }

    MaterialIndex white_, brass_, gold_, dark_wood_;
};

}  // namespace
}  // namespace room

Result<scene::Scene> make_room(const SceneOptions& options) { return room::Room(options).build(); }

}  // namespace balcony::plates
