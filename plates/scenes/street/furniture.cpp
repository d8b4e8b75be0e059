// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/street/furniture.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "scenes/street/street.hpp"

namespace balcony::plates::street {

namespace {

using scene::MaterialIndex;
using scene::MeshIndex;
using std::numbers::pi;

// Numbers that look random, in [0, 1), one after the other.
class Dice {
public:
    explicit Dice(std::uint32_t seed) : seed_(seed) {}
    double operator()() { return lattice_noise(++count_, 17, seed_); }

private:
    std::uint32_t seed_;
    int count_ = 0;
};

// A crown of single leaves, gathered around the ends of the boughs.
MeshBuilder crown(std::uint32_t seed) {
    constexpr int boughs = 17;
    constexpr int leaves = 150;
    Dice dice(seed);
    MeshBuilder built;
    for (int i = 0; i < boughs; ++i) {
        const double z = 1.0 - 2.0 * (i + 0.5) / boughs;
        const double angle = 2.39996 * i;
        const double flat = std::sqrt(1.0 - z * z);
        const V3d bough(1.15 * flat * std::cos(angle), 1.15 * flat * std::sin(angle),
                        4.9 + 1.75 * z);
        for (int k = 0; k < leaves; ++k) {
            const V3d way(dice() - 0.5, dice() - 0.5, dice() - 0.5);
            const V3d at = bough + way.normalized() * 0.72 * std::cbrt(dice());
            const V3d a = V3d(dice() - 0.5, dice() - 0.5, dice() - 0.5).normalized() * 0.1;
            const V3d b =
                a.cross(V3d(dice() - 0.5, dice() - 0.5, dice() - 0.5)).normalized() * 0.07;
            built.quad(at - a, at + b, at + a, at - b);
        }
    }
    return built;
}

MeshBuilder trunk() {
    MeshBuilder built;
    built.tube({{V3d(0, 0, -0.1), 0.17},
                {V3d(0.02, 0, 1.5), 0.13},
                {V3d(-0.03, 0.03, 3.2), 0.11},
                {V3d(0.05, -0.02, 5.2), 0.05}},
               10);
    for (int i = 0; i < 6; ++i) {
        const double angle = 2.4 * i;
        const V3d out(std::cos(angle), std::sin(angle), 0.0);
        built.tube({{V3d(0, 0, 2.6 + 0.3 * i), 0.06},
                    {out * 0.5 + V3d(0, 0, 3.3 + 0.35 * i), 0.04},
                    {out * 1.0 + V3d(0, 0, 3.9 + 0.35 * i), 0.02}},
                   6);
    }
    return built;
}

MeshBuilder lamp_post() {
    MeshBuilder built;
    built.lathe(V3d(0.0),
                {{0.16, 0},
                 {0.16, 0.12},
                 {0.11, 0.18},
                 {0.09, 0.7},
                 {0.06, 0.8},
                 {0.045, 0.9},
                 {0.035, 3.5},
                 {0.06, 3.56},
                 {0.03, 3.62}},
                14);
    built.lathe(V3d(0, 0, 3.62), {{0.06, 0}, {0.1, 0.04}, {0.1, 0.06}}, 8);
    built.lathe(V3d(0, 0, 4.16), {{0.24, 0}, {0.2, 0.1}, {0.06, 0.26}, {0.05, 0.36}, {0.0, 0.4}},
                8);
    for (int i = 0; i < 4; ++i) {
        const double angle = pi / 4 + pi / 2 * i;
        const V3d out(std::cos(angle), std::sin(angle), 0.0);
        built.tube({{out * 0.1 + V3d(0, 0, 3.66), 0.012}, {out * 0.22 + V3d(0, 0, 4.17), 0.012}},
                   6);
    }
    return built;
}

MeshBuilder bicycle() {
    MeshBuilder built;
    for (const double x : {-0.53, 0.53}) {
        std::vector<MeshBuilder::Bead> tyre;
        for (int k = 0; k <= 24; ++k) {
            const double angle = 2 * pi * k / 24;
            tyre.push_back(
                {V3d(x + 0.33 * std::cos(angle), 0, 0.35 + 0.33 * std::sin(angle)), 0.018});
        }
        built.tube(tyre, 6);
    }
    const auto bar = [&](const V3d& a, const V3d& b) { built.tube({{a, 0.017}, {b, 0.017}}, 6); };
    const V3d crank(-0.05, 0, 0.32);
    const V3d seat(-0.22, 0, 0.82);
    const V3d head(0.36, 0, 0.85);
    bar(crank, seat);
    bar(crank, head);
    bar(seat, head);
    bar(V3d(-0.53, 0, 0.35), crank);
    bar(V3d(-0.53, 0, 0.35), seat);
    bar(V3d(0.53, 0, 0.35), head);
    bar(head, V3d(0.33, 0, 1.02));
    bar(V3d(0.25, -0.25, 1.02), V3d(0.33, 0, 1.02));
    bar(V3d(0.25, 0.25, 1.02), V3d(0.33, 0, 1.02));
    built.ellipsoid(V3d(-0.25, 0, 0.9), V3d(0.14, 0.07, 0.04), 10);
    return built;
}

M44d at(double x, double y, double turn = 0.0, double z = 0.13) {
    return M44d().setAxisAngle(V3d(0, 0, 1), turn) * M44d().setTranslation(V3d(x, y, z));
}

MeshBuilder table_with_chairs() {
    MeshBuilder table;
    table.tube({{V3d(0, 0, 0.05), 0.03}, {V3d(0, 0, 2.65), 0.025}}, 8);
    table.lathe(V3d(0.0), {{0.25, 0}, {0.25, 0.05}, {0.03, 0.09}}, 16);
    table.lathe(V3d(0, 0, 0.72), {{0.0, 0}, {0.38, 0}, {0.38, 0.03}, {0.0, 0.03}}, 20);
    MeshBuilder chair;
    chair.box(V3d(-0.2, -0.2, 0.42), V3d(0.2, 0.2, 0.46));
    chair.box(V3d(-0.2, 0.18, 0.46), V3d(0.2, 0.21, 0.88));
    for (const double x : {-0.18, 0.18}) {
        for (const double y : {-0.18, 0.18}) {
            chair.tube({{V3d(x, y, 0.0), 0.02}, {V3d(x, y, 0.44), 0.02}}, 6);
        }
    }
    for (int k = 0; k < 3; ++k) {
        const double angle = 2.1 * k + 0.4;
        table.add(chair,
                  M44d().setAxisAngle(V3d(0, 0, 1), angle - pi / 2) *
                      M44d().setTranslation(V3d(0.7 * std::cos(angle), 0.7 * std::sin(angle), 0)));
    }
    return table;
}

MeshBuilder figure() {
    MeshBuilder built;
    built.lathe(V3d(0.0),
                {{0.16, 0.45}, {0.24, 0.5}, {0.19, 0.95}, {0.22, 1.3}, {0.2, 1.4}, {0.06, 1.48}},
                14);
    for (const double side : {-1.0, 1.0}) {
        built.tube({{V3d(0.12 * side, 0.08 * side, 0.03), 0.06}, {V3d(0, 0.09 * side, 0.6), 0.08}},
                   8);
        built.tube(
            {{V3d(0, 0.22 * side, 1.33), 0.06}, {V3d(-0.1 * side, 0.27 * side, 0.85), 0.045}}, 8);
    }
    return built;
}

// A shape in several colours.
template <std::size_t count>
std::vector<MeshIndex> in_colors(SceneBuilder& builder, const char* name, const scene::Mesh& shape,
                                 const std::array<std::uint32_t, count>& colors, float roughness) {
    std::vector<MeshIndex> kinds;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string kind = fmt::format("{} {}", name, i + 1);
        kinds.push_back(
            builder.mesh(kind, shape, builder.material(kind, tint(colors[i]), roughness)));
    }
    return kinds;
}

MeshIndex kind_of(const std::vector<MeshIndex>& kinds, int number) {
    return kinds[static_cast<std::size_t>(number) % kinds.size()];
}

void add_tram(SceneBuilder& builder, const Stock& stock) {
    const M44d placed = at(55.0, 1.75, 0.0, 0.0);
    const auto put = [&](const char* name, const MeshBuilder& built, MaterialIndex material) {
        builder.place(name, builder.mesh(name, built.mesh(), material), placed);
    };
    const MaterialIndex red = builder.material("tram red", tint(0x9e2a22), 0.3F);
    const MaterialIndex cream = builder.material("tram cream", tint(0xf0e3c4), 0.35F);
    MeshBuilder body, top, band, details;
    for (const double x : {-7.2, 0.1}) {
        body.box(V3d(x, -1.15, 0.35), V3d(x + 7.0, 1.15, 1.5), 0.12);
        top.box(V3d(x, -1.15, 1.5), V3d(x + 7.0, 1.15, 3.15), 0.12);
        body.box(V3d(x + 0.3, -0.85, 3.1), V3d(x + 6.7, 0.85, 3.28), 0.08);
        for (int i = 0; i < 6; ++i) {
            band.box(V3d(x + 0.3 + 1.1 * i, -1.17, 1.75), V3d(x + 1.2 + 1.1 * i, 1.17, 2.8));
        }
        details.box(V3d(x + 1.5, -0.5, 3.3), V3d(x + 2.6, 0.5, 3.5), 0.04);
        details.box(V3d(x + 4.4, -0.6, 3.3), V3d(x + 5.8, 0.6, 3.46), 0.04);
        details.box(V3d(x + 0.6, -1.0, 0.05), V3d(x + 6.4, 1.0, 0.4));
    }
    details.box(V3d(-0.25, -0.9, 0.5), V3d(0.15, 0.9, 3.0));
    const std::array<V3d, 4> bow{V3d(-3.9, 0.45, 3.4), V3d(-3.0, 0.5, 4.0), V3d(-3.9, 0.6, 4.5),
                                 V3d(-3.9, -0.6, 4.5)};
    for (const double side : {1.0, -1.0}) {
        details.tube({{bow[0] * V3d(1, side, 1), 0.03},
                      {bow[1] * V3d(1, side, 1), 0.03},
                      {bow[2] * V3d(1, side, 1), 0.03}},
                     6);
    }
    details.tube({{bow[2], 0.035}, {bow[3], 0.035}}, 6);
    put("tram body", body, red);
    put("tram top", top, cream);
    put("tram windows", band, stock.glass);
    put("tram roof gear", details, stock.iron);
}

}  // namespace

Furniture::Furniture(SceneBuilder& builder, const Stock& stock) : builder_(builder) {
    constexpr std::array<std::uint32_t, 3> autumn{0xd8912a, 0xc9762a, 0xa8902f};
    for (std::size_t i = 0; i < autumn.size(); ++i) {
        crowns_.push_back(builder.mesh(
            fmt::format("crown {}", i + 1), crown(static_cast<std::uint32_t>(i) + 91U).mesh(),
            builder.material(fmt::format("autumn leaves {}", i + 1), tint(autumn[i]), 0.8F)));
    }
    trunk_ = builder.mesh("trunk", trunk().mesh(), builder.material("bark", tint(0x4d4238), 0.95F));
    post_ = builder.mesh("lamp post", lamp_post().mesh(), stock.iron);
    scene::Material light;
    light.name = "lantern";
    light.base_color = tint(0xfff0d0);
    light.emission = scene::Color3f(1.0F, 0.66F, 0.3F) * 9000.0F;
    lantern_ = builder.mesh(
        "lantern",
        MeshBuilder().lathe(V3d(0, 0, 3.68), {{0.09, 0}, {0.2, 0.48}, {0.0, 0.48}}, 4).mesh(),
        builder.material(light));
    constexpr std::array<std::uint32_t, 4> frames{0x2b2d30, 0x9b2f26, 0x2f5d62, 0x3c5a3a};
    bicycles_ = in_colors(builder, "bicycle", street::bicycle().mesh(), frames, 0.4F);
    parasol_ = builder.mesh(
        "parasol",
        MeshBuilder()
            .lathe(V3d(0, 0, 2.15), {{1.15, 0}, {1.1, 0.05}, {0.03, 0.55}, {0.0, 0.58}}, 8)
            .mesh(),
        builder.material("parasol", tint(0xb5402c), 0.8F));
    table_ = builder.mesh("café table", table_with_chairs().mesh(), stock.iron);
    head_ = builder.mesh("head",
                         MeshBuilder().ellipsoid(V3d(0, 0, 1.6), V3d(0.1, 0.09, 0.13), 12).mesh(),
                         builder.material("skin", tint(0xc89878), 0.6F));
    constexpr std::array<std::uint32_t, 5> cloth{0x23395b, 0x7b2d26, 0xc9a227, 0x3a3a3c, 0x4f6d4a};
    coats_ = in_colors(builder, "coat", figure().mesh(), cloth, 0.9F);
    ridden_ = builder.mesh("ridden bicycle", street::bicycle().mesh(),
                           builder.material("black paint", tint(0x202224), 0.4F));
}

void Furniture::tree(const M44d& placed) {
    const MeshIndex crown = kind_of(crowns_, trees_++);
    builder_.place(fmt::format("tree {} crown", trees_), crown, placed);
    builder_.place(fmt::format("tree {} trunk", trees_), trunk_, placed);
}

void Furniture::lamp(const M44d& placed) {
    ++lamps_;
    builder_.place(fmt::format("lamp {} post", lamps_), post_, placed);
    builder_.place(fmt::format("lamp {} lantern", lamps_), lantern_, placed);
}

void Furniture::bicycle(const M44d& placed) {
    const MeshIndex kind = kind_of(bicycles_, parked_++);
    builder_.place(fmt::format("bicycle {}", parked_), kind, placed);
}

void Furniture::table(const M44d& placed) {
    ++tables_;
    const auto turned = [&](double angle) { return at(0.0, 0.0, angle, 0.0) * placed; };
    builder_.place(fmt::format("parasol {}", tables_), parasol_, turned(0.3 * tables_));
    builder_.place(fmt::format("café table {}", tables_), table_, turned(0.9 * tables_));
}

void Furniture::cyclist(const M44d& placed) {
    const M44d seated = M44d().setTranslation(V3d(-0.2, 0.0, 0.28)) * placed;
    const MeshIndex coat = kind_of(coats_, cyclists_++);
    const std::string name = fmt::format("cyclist {}", cyclists_);
    builder_.place(name + " bicycle", ridden_, placed);
    builder_.place(name + " coat", coat, seated);
    builder_.place(name + " head", head_, seated);
}

void Furniture::person(const M44d& placed) {
    const MeshIndex coat = kind_of(coats_, 7 * people_++);
    builder_.place(fmt::format("person {} coat", people_), coat, placed);
    builder_.place(fmt::format("person {} head", people_), head_, placed);
}

void add_furniture(SceneBuilder& builder, const Stock& stock) {
    using Place = std::array<double, 3>;  // x, y and a turn.
    Furniture furniture(builder, stock);
    constexpr std::array<Place, 13> trees{{{4.0, 1, 0.9},
                                           {17.5, 1, 1.0},
                                           {38.0, 1, 0.85},
                                           {52.5, 1, 1.0},
                                           {75.5, 1, 0.95},
                                           {90.0, 1, 1.05},
                                           {108.5, 1, 0.85},
                                           {9.5, -1, 1.0},
                                           {27.0, -1, 0.85},
                                           {46.0, -1, 1.0},
                                           {64.5, -1, 0.9},
                                           {83.0, -1, 1.0},
                                           {101.5, -1, 0.95}}};
    double turn = 0.0;
    for (const auto& [x, side, size] : trees) {
        furniture.tree(M44d().setScale(V3d(size)) * at(x, side * 5.4, turn));
        turn += 1.3;
    }
    for (int i = 0; i < 6; ++i) {
        for (const double side : {1.0, -1.0}) {
            furniture.lamp(at(11.0 + 18.5 * i + (side > 0 ? 0.0 : 9.0), side * 4.95));
        }
    }
    constexpr std::array<Place, 12> parked{{{6.2, 7.55, 0.06},
                                            {7.0, 7.5, 3.1},
                                            {24.4, 7.55, 0.0},
                                            {44.0, 7.55, 3.2},
                                            {66.4, 7.5, 0.1},
                                            {67.6, 7.55, 0.0},
                                            {98.0, 7.55, 3.1},
                                            {15.0, -7.55, 0.0},
                                            {36.0, -7.5, 3.2},
                                            {37.1, -7.55, 0.1},
                                            {71.0, -7.55, 0.0},
                                            {94.5, -7.5, 3.1}}};
    for (const auto& [x, y, angle] : parked) {
        furniture.bicycle(at(x, y, angle));
    }
    add_tram(builder, stock);
    constexpr std::array<std::array<double, 2>, 5> tables{
        {{28.6, 5.6}, {31.4, 5.9}, {34.0, 5.5}, {87.0, -5.7}, {89.8, -5.5}}};
    for (const auto& [x, y] : tables) {
        furniture.table(at(x, y));
    }
    constexpr std::array<Place, 6> ways{{{8.6, 2.9, 0.05},
                                         {22.0, 0.1, 0.0},
                                         {34.2, 3.3, 0.1},
                                         {66.0, 3.2, 3.1},
                                         {88.4, 2.6, 3.2},
                                         {102.0, 0.4, 0.0}}};
    for (const auto& [x, y, angle] : ways) {
        furniture.cyclist(at(x, y, angle, 0.0));
    }
    constexpr std::array<Place, 16> people{{{13.2, 6.4, 0.1},
                                            {14.0, 6.6, 0.1},
                                            {41.5, 6.2, 3.2},
                                            {58.0, 6.7, 0.0},
                                            {63.0, 5.9, 2.9},
                                            {80.6, 6.3, 0.2},
                                            {104.0, 6.5, 3.1},
                                            {20.5, -6.4, 0.0},
                                            {43.0, -6.2, 3.1},
                                            {58.5, -6.5, 0.1},
                                            {78.2, -6.3, 3.3},
                                            {105.5, -6.4, 0.0},
                                            {70.2, 2.6, 1.4},
                                            {71.0, 3.4, 1.5},
                                            {69.8, 0.9, 4.6},
                                            {71.6, -1, 1.7}}};
    for (const auto& [x, y, angle] : people) {
        furniture.person(at(x, y, angle, std::fabs(y) > 4.4 ? 0.13 : 0.0));
    }
}

}  // namespace balcony::plates::street
