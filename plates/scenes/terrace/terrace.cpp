// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/terrace/terrace.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "common/mesh_builder.hpp"
#include "common/meshes.hpp"
#include "common/scene_builder.hpp"
#include "common/solids.hpp"
#include "scenes/candle/candle.hpp"
#include "scenes/chess/chess.hpp"
#include "scenes/street/furniture.hpp"
#include "scenes/street/house.hpp"

namespace balcony::plates {

namespace terrace {
namespace {

using scene::Color3f;
using scene::Material;
using scene::MaterialIndex;
using std::numbers::pi;
using namespace street;

constexpr double half_width = 4.5;  // Of the lane, from front to front.
constexpr double begin = 2.0;       // Of the houses, along x.

constexpr std::array plans{
    Plan{7.5, 3, 3, Ground::shop, Top::eaves, Wall::plaster, 0xd79a5c, 0x2f5548},
    Plan{6.5, 4, 3, Ground::door, Top::stepped, Wall::brick, 0x9e604a, 0x1f3b34},
    Plan{8.0, 3, 3, Ground::arcade, Top::eaves, Wall::plaster, 0xe0cfae, 0x6b4a32},
    Plan{6.0, 3, 2, Ground::door, Top::bell, Wall::plaster, 0xc9745a, 0x273b52},
    Plan{8.5, 4, 3, Ground::cafe, Top::mansard, Wall::plaster, 0xd9927a, 0x7c2f28, false, true},
    Plan{7.0, 4, 3, Ground::door, Top::pediment, Wall::brick, 0xa9684c, 0x23443f, true},
};

class Terrace {
public:
    explicit Terrace(const SceneOptions& options) : builder_("terrace", options) {}

    Result<scene::Scene> build() && {
        Stock stock = make_stock(builder_);
        Material lit;
        lit.name = "lit by night";
        lit.base_color = tint(0xf2d6a2);
        lit.emission = Color3f(1.0F, 0.6F, 0.26F) * 140.0F;
        stock.lamplight = builder_.material(lit);
        add_lane(stock);
        add_lampions(stock);
        add_table(stock);
        add_game_of_chess(builder_, M44d().setScale(0.01) * turned(-70.0 * pi / 180.0) *
                                        M44d().setTranslation(V3d(0, 0, board_height)));
        add_burning_candle(builder_,
                           M44d().setScale(0.01) * M44d().setTranslation(V3d(0.18, 0.165, top)),
                           9000.0F);
        add_window();
        return std::move(builder_).finish();
    }

private:
    static constexpr double top = 0.76;  // Of the table.

    static M44d turned(double angle) { return M44d().setAxisAngle(V3d(0, 0, 1), angle); }

    void put(const std::string& name, const MeshBuilder& built, MaterialIndex material) {
        builder_.place(name, builder_.mesh(name, built.mesh(), material));
    }

    // Houses on both sides, and across the end.
    void add_lane(const Stock& stock) {
        put("roadway",
            MeshBuilder().quad(V3d(-20, -30, 0), V3d(70, -30, 0), V3d(70, 30, 0), V3d(-20, 30, 0)),
            stock.road);
        std::size_t next = 0;
        const auto house = [&](const std::string& name, const V3d& foot, double angle) {
            const Plan& plan = plans[next++ % plans.size()];
            add_house(
                builder_, stock, name, plan,
                turned(angle) * M44d().setTranslation(foot + (angle == pi ? plan.width : 0.0) *
                                                                 V3d(1.0, 0.0, 0.0)));
            return plan.width;
        };
        double left = begin;
        double right = begin + 1.5;
        for (int i = 1; i <= 5; ++i) {
            left += house(fmt::format("left house {}", i), V3d(left, half_width, 0.0), 0.0);
            right += house(fmt::format("right house {}", i), V3d(right, -half_width, 0.0), pi);
        }
        double across = 10.0;
        for (int i = 1; i <= 3; ++i) {
            across -= house(fmt::format("last house {}", i), V3d(44.0, across, 0.0), -0.5 * pi);
        }
    }

    // Cords from front to front, which sag, with a lampion every so often.
    void add_lampions(const Stock& stock) {
        struct Paper {
            const char* name;
            std::uint32_t color;
            float light;  // cd/m²
        };
        constexpr std::array papers{
            Paper{"amber paper", 0xff9f3f, 4000.0F}, Paper{"white paper", 0xffc878, 3800.0F},
            Paper{"red paper", 0xff3d22, 4200.0F},   Paper{"amber paper", 0xff9236, 4000.0F},
            Paper{"green paper", 0x6cc79a, 2600.0F}, Paper{"rose paper", 0xff6a58, 3800.0F}};
        std::vector<scene::MeshIndex> kinds;
        for (const Paper& paper : papers) {
            Material glowing;
            glowing.name = paper.name;
            glowing.base_color = tint(paper.color);
            glowing.emission = tint(paper.color) * paper.light;
            kinds.push_back(
                builder_.mesh("lampion", sphere(lampion_radius, 16), builder_.material(glowing)));
        }
        constexpr int per_cord = 8;
        int number = 0;
        MeshBuilder cords;
        for (int cord = 0; cord < 5; ++cord) {
            const double x = 5.5 + 2.6 * cord;
            const double slant = 1.2 * std::sin(2.3 * cord);
            const double height = 2.4 + 0.35 * std::sin(1.7 * cord + 0.5);
            const auto at = [&](double t) {  // t from -1 to 1
                return V3d(x + slant * t, half_width * t,
                           height - 0.75 * (1.0 - t * t) + 0.3 * t * std::sin(3.1 * cord));
            };
            std::vector<MeshBuilder::Bead> beads;
            for (int k = 0; k <= 20; ++k) {
                beads.push_back({at(0.1 * k - 1.0), 0.006});
            }
            cords.tube(beads, 6);
            for (int k = 0; k < per_cord; ++k) {
                const double t = (2.0 * k + 1.0) / per_cord - 1.0 + 0.03 * std::sin(9.0 * number);
                const auto kind = static_cast<std::size_t>(3 * cord + 5 * k + k * k) % kinds.size();
                builder_.place(fmt::format("lampion {}", ++number), kinds[kind],
                               M44d().setTranslation(at(t) - V3d(0, 0, lampion_radius + 0.03)));
            }
        }
        put("cords", cords, stock.iron);
    }

    // Round, with an iron foot.
    void add_table(const Stock& stock) {
        constexpr double radius = 0.42;
        put("table",
            MeshBuilder().lathe(V3d(0.0),
                                {{radius - 0.01, top - 0.03},
                                 {radius, top - 0.025},
                                 {radius, top - 0.006},
                                 {radius - 0.006, top},
                                 {radius - 0.006, top},
                                 {0.0, top}},
                                96),
            builder_.material("table", tint(0x5a3a26), 0.35F));
        put("foot of the table",
            MeshBuilder().lathe(V3d(0.0),
                                {{0.25, 0.0}, {0.24, 0.03}, {0.03, 0.06}, {0.03, top - 0.03}}, 32),
            stock.iron);
    }

    // The window of the café, behind whom the picture is seen by.
    void add_window() {
        Material window;
        window.name = "window";
        window.base_color = Color3f(0.0F);
        window.emission = Color3f(1.0F, 0.72F, 0.45F) * 6000.0F;
        builder_.place("window",
                       builder_.mesh("window", rectangle(0.9, 1.2), builder_.material(window)),
                       M44d().setEulerAngles(V3d(0.0, 1.15, -0.75)) *
                           M44d().setTranslation(V3d(-1.5, 1.3, 1.5)));
    }

    SceneBuilder builder_;
};

}  // namespace
}  // namespace terrace

Result<scene::Scene> make_terrace(const SceneOptions& options) {
    return terrace::Terrace(options).build();
}

}  // namespace balcony::plates
