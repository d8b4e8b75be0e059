// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/lane/lane.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "common/mesh_builder.hpp"
#include "common/scene_builder.hpp"
#include "scenes/street/furniture.hpp"
#include "scenes/street/house.hpp"

namespace balcony::plates {

namespace lane {
namespace {

using Imath::V2d;
using Imath::V3d;
using scene::MaterialIndex;
using std::numbers::pi;
using namespace street;

// Both sides of the lane take these in turn, each a little wider or narrower than here.
constexpr std::array plans{
    Plan{7.5, 3, 3, Ground::shop, Top::eaves, Wall::plaster, 0xe0b06a, 0x2f5548},
    Plan{6.5, 4, 3, Ground::door, Top::stepped, Wall::brick, 0x9e604a, 0x1f3b34},
    Plan{8.0, 3, 3, Ground::arcade, Top::eaves, Wall::plaster, 0xe9dcc0, 0x6b4a32},
    Plan{6.0, 3, 2, Ground::door, Top::bell, Wall::plaster, 0xc9745a, 0x273b52},
    Plan{8.5, 4, 3, Ground::cafe, Top::mansard, Wall::plaster, 0xd9927a, 0x7c2f28, false, true},
    Plan{7.0, 4, 3, Ground::door, Top::pediment, Wall::brick, 0xa9684c, 0x23443f, true},
    Plan{7.5, 3, 3, Ground::shop, Top::eaves, Wall::plaster, 0xa9b7be, 0x6b2c28, false, true},
    Plan{6.5, 4, 2, Ground::shop, Top::stepped, Wall::brick, 0xb87a4e, 0x28352f},
    Plan{8.0, 3, 3, Ground::door, Top::mansard, Wall::plaster, 0xf0e2bd, 0x30505e, true},
    Plan{6.0, 3, 2, Ground::shop, Top::bell, Wall::brick, 0x8a5142, 0x24405c},
    Plan{7.5, 4, 3, Ground::arcade, Top::eaves, Wall::plaster, 0x9fb2a2, 0xb5542f},
};

V2d direction(std::size_t leg) { return (corners[leg + 1] - corners[leg]).normalized(); }
V2d to_left(const V2d& v) { return {-v.y, v.x}; }

// The point of a line beside the lane where a leg begins, to the left of its middle; lines turn
// where the middle does. The number of legs is where the last one ends.
V2d beside(std::size_t leg, double left) {
    const V2d before = to_left(direction(leg == 0 ? 0 : leg - 1));
    const V2d behind = to_left(direction(std::min(leg, legs - 1)));
    return corners[leg] + left * (leg == 0 || leg == legs ? behind : before + behind);
}

V3d lifted(const V2d& p, double z) { return {p.x, p.y, z}; }

class Lane {
public:
    explicit Lane(const SceneOptions& options) : builder_("lane", options) {}

    Result<scene::Scene> build() && {
        const Stock stock = make_stock(builder_);
        add_ground(stock);
        for (std::size_t leg = 0; leg < legs; ++leg) {
            add_row(stock, leg, true);
            add_row(stock, leg, false);
        }
        add_church(stock);
        add_furniture(stock);
        return std::move(builder_).finish();
    }

private:
    void put(const char* name, const MeshBuilder& built, MaterialIndex material) {
        builder_.place(name, builder_.mesh(name, built.mesh(), material));
    }

    void add_ground(const Stock& stock) {
        constexpr double curb = 3.1;
        put("roadway",
            MeshBuilder().quad(V3d(-60, -60, 0), V3d(140, -60, 0), V3d(140, 140, 0),
                               V3d(-60, 140, 0)),
            stock.road);
        MeshBuilder walks;
        MeshBuilder curbs;
        const auto strip = [](MeshBuilder& built, std::size_t leg, double from, double low,
                              double to, double high) {
            built.quad(lifted(beside(leg, from), low), lifted(beside(leg + 1, from), low),
                       lifted(beside(leg + 1, to), high), lifted(beside(leg, to), high));
        };
        for (std::size_t leg = 0; leg < legs; ++leg) {
            for (const double side : {1.0, -1.0}) {
                strip(walks, leg, side * curb, 0.13, side * (half_width + 0.5), 0.13);
                strip(curbs, leg, side * (curb - 0.2), 0.0, side * (curb - 0.2), 0.14);
                strip(curbs, leg, side * (curb - 0.2), 0.14, side * curb, 0.14);
            }
        }
        put("pavements", walks, stock.walk);
        put("curbs", curbs, stock.stone);
    }

    // As many houses as fit, and as wide as fill the row.
    void add_row(const Stock& stock, std::size_t leg, bool left) {
        const double side = left ? half_width : -half_width;
        const V2d begin = beside(leg, side);
        const V2d along = direction(leg);
        const double length = (beside(leg + 1, side) - begin).dot(along);
        std::vector<Plan> row;
        double width = 0.0;
        while (width + 3.5 < length) {
            row.push_back(plans[next_++ % plans.size()]);
            width += row.back().width;
        }
        const double angle = std::atan2(along.y, along.x);
        double at = 0.0;
        for (std::size_t i = 0; i < row.size(); ++i) {
            Plan plan = row[i];
            plan.width *= length / width;
            const V2d foot = begin + (left ? at : at + plan.width) * along;
            const M44d placed = M44d().setAxisAngle(V3d(0, 0, 1), left ? angle : angle + pi) *
                                M44d().setTranslation(lifted(foot, 0.0));
            add_house(builder_, stock,
                      fmt::format("{} house {}.{}", left ? "left" : "right", leg + 1, i + 1), plan,
                      placed);
            at += plan.width;
        }
    }

    // A tower at the end of the lane, before the gable of its church.
    void add_church(const Stock& stock) {
        const M44d placed = M44d().setTranslation(lifted(corners[legs] + V2d(0.0, 6.0), 0.0));
        const auto put_here = [&](const char* name, const MeshBuilder& built,
                                  MaterialIndex material) {
            builder_.place(name, builder_.mesh(name, built.mesh(), material), placed);
        };
        MeshBuilder stone;
        MeshBuilder dark;
        MeshBuilder roof;
        stone.box(V3d(-3.6, 0, 0), V3d(3.6, 7.2, 22), 0.15);
        stone.box(V3d(-14, 4.5, 0), V3d(14, 30, 11));
        for (const double z : {7.5, 15.0, 21.6}) {
            stone.box(V3d(-3.85, -0.25, z), V3d(3.85, 7.45, z + 0.4), 0.1);
        }
        for (const double x : {-1.0, 1.0}) {
            for (const double y : {-1.0, 1.0}) {
                stone.box(V3d(3.1 * x - 0.55, 3.6 + 3.1 * y - 0.55, 0),
                          V3d(3.1 * x + 0.55, 3.6 + 3.1 * y + 0.55, 23.6), 0.1);
                roof.lathe(V3d(3.1 * x, 3.6 + 3.1 * y, 23.6), {{0.75, 0}, {0.0, 2.4}}, 8);
            }
            dark.box(V3d(x * 1.25 - 0.65, -0.05, 16.2), V3d(x * 1.25 + 0.65, 0.2, 20.4), 0.05);
        }
        dark.box(V3d(-1.3, -0.06, 0), V3d(1.3, 0.2, 4.0), 0.05);
        stone.box(V3d(-1.7, -0.3, 0), V3d(-1.3, 0.2, 4.2), 0.05);
        stone.box(V3d(1.3, -0.3, 0), V3d(1.7, 0.2, 4.2), 0.05);
        stone.box(V3d(-1.9, -0.4, 4.2), V3d(1.9, 0.2, 4.7), 0.1);
        roof.lathe(V3d(0, 3.6, 22), {{4.3, 0}, {2.9, 4.5}, {2.4, 5.0}, {0.0, 21.0}}, 8);
        roof.quad(V3d(-14, 4.5, 11), V3d(-14, 30, 11), V3d(0, 30, 19), V3d(0, 4.5, 19));
        roof.quad(V3d(14, 30, 11), V3d(14, 4.5, 11), V3d(0, 4.5, 19), V3d(0, 30, 19));
        stone.triangle(V3d(-14, 4.5, 11), V3d(14, 4.5, 11), V3d(0, 4.5, 19));
        put_here("church", stone, stock.stone);
        put_here("church openings", dark, stock.glass);
        put_here("church roofs", roof, stock.slate);
        put_here("clock", clock_face(),
                 builder_.material("gilding", scene::Color3f(0.9F, 0.62F, 0.2F), 0.35F));
        put_here("clock face", MeshBuilder().add(disc(1.45), upright(-0.1)),
                 builder_.material("clock face", tint(0x1d2b45), 0.5F));
    }

    static M44d upright(double y) {
        return M44d().setAxisAngle(V3d(1, 0, 0), pi / 2) * M44d().setTranslation(V3d(0.0, y, 11.6));
    }
    static MeshBuilder disc(double radius) {
        return MeshBuilder().lathe(V3d(0.0), {{radius, -0.1}, {radius, 0.0}, {0.0, 0.0}}, 40);
    }

    // A ring, twelve marks and two hands: ten to seven.
    static MeshBuilder clock_face() {
        MeshBuilder face;
        face.lathe(V3d(0.0), {{1.7, -0.1}, {1.7, 0.06}, {1.45, 0.06}, {1.45, 0.0}}, 40);
        const auto bar = [&](double angle, double from, double to, double width) {
            MeshBuilder one;
            one.box(V3d(-width, from, 0.0), V3d(width, to, 0.06));
            face.add(one, M44d().setAxisAngle(V3d(0, 0, 1), -angle));
        };
        for (int hour = 0; hour < 12; ++hour) {
            bar(hour * pi / 6.0, 1.1, 1.35, 0.05);
        }
        bar(2.0 * pi * 50.0 / 60.0, -0.25, 1.15, 0.045);
        bar(2.0 * pi * (6.0 + 50.0 / 60.0) / 12.0, -0.2, 0.8, 0.065);
        return MeshBuilder().add(face, upright(-0.1));
    }

    // A place by the length along a leg and to the left of its middle, turned from its direction.
    static M44d place(std::size_t leg, double along, double left, double turn = 0.0) {
        const V2d way = direction(leg);
        const V2d p = corners[leg] + along * way + left * to_left(way);
        return M44d().setAxisAngle(V3d(0, 0, 1), std::atan2(way.y, way.x) + turn) *
               M44d().setTranslation(lifted(p, std::abs(left) > 3.0 ? 0.13 : 0.0));
    }

    void add_furniture(const Stock& stock) {
        struct Spot {
            std::size_t leg;
            double along, left, turn;
        };
        Furniture furniture(builder_, stock);
        for (const Spot& one :
             {Spot{0, 31.0, 4.0, 0.4}, Spot{1, 11.0, -3.9, 1.1}, Spot{2, 20.0, 3.9, 2.0},
              Spot{3, 13.0, -3.9, 0.2}, Spot{3, 29.0, 3.9, 2.9}}) {
            furniture.tree(M44d().setScale(0.72) * place(one.leg, one.along, one.left, one.turn));
        }
        for (std::size_t leg = 0; leg < legs; ++leg) {
            const double length = (corners[leg + 1] - corners[leg]).length();
            for (double along = 12.0; along < length - 6.0; along += 15.0) {
                furniture.lamp(place(leg, along, 3.5));
                furniture.lamp(place(leg, along + 6.0, -3.5));
            }
        }
        for (const Spot& one :
             {Spot{0, 24.0, -4.9, 0.1}, Spot{0, 25.1, -4.85, 3.1}, Spot{1, 21.0, 4.9, 0.0},
              Spot{2, 14.0, -4.9, 3.2}, Spot{3, 10.0, 4.9, 0.1}, Spot{3, 24.0, -4.85, 0.0}}) {
            furniture.bicycle(place(one.leg, one.along, one.left, one.turn));
        }
        for (const Spot& one : {Spot{0, 38.0, 4.2, 0.0}, Spot{0, 41.2, 4.3, 0.0},
                                Spot{2, 27.0, -4.1, 0.0}, Spot{2, 30.0, -4.2, 0.0}}) {
            furniture.table(place(one.leg, one.along, one.left, one.turn));
        }
        for (const Spot& one :
             {Spot{0, 33.0, -1.4, 0.05}, Spot{1, 24.0, 1.2, 3.1}, Spot{3, 21.0, -1.0, 0.0}}) {
            furniture.cyclist(place(one.leg, one.along, one.left, one.turn));
        }
        for (const Spot& one :
             {Spot{0, 27.0, 1.0, 0.1}, Spot{0, 27.4, 1.9, 0.0}, Spot{0, 36.0, -4.2, 3.2},
              Spot{0, 47.0, -2.2, 0.5}, Spot{1, 9.0, -1.2, 1.4}, Spot{1, 17.0, 2.4, 3.0},
              Spot{1, 28.0, -4.0, 0.1}, Spot{2, 10.0, 0.6, 0.0}, Spot{2, 17.0, -2.2, 3.2},
              Spot{2, 24.0, 1.6, 0.2}, Spot{3, 8.0, 1.2, 3.0}, Spot{3, 15.0, -1.6, 0.0},
              Spot{3, 26.0, 0.9, 3.3}, Spot{3, 33.0, -2.0, 0.1}}) {
            furniture.person(place(one.leg, one.along, one.left, one.turn));
        }
    }

    SceneBuilder builder_;
    std::size_t next_ = 0;  // Of the plans.
};

}  // namespace
}  // namespace lane

Result<scene::Scene> make_lane(const SceneOptions& options) { return lane::Lane(options).build(); }

}  // namespace balcony::plates
