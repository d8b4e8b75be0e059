// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/street/street.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "common/meshes.hpp"
#include "scenes/street/furniture.hpp"
#include "scenes/street/house.hpp"

namespace balcony::plates {

namespace street {
namespace {

using scene::MaterialIndex;

// From west to east. House 9 of the northern row stands back and is as wide as house 3; house 10 of
// the southern row, as house 4.
constexpr std::array north{
    Plan{8.0, 4, 3, Ground::shop, Top::eaves, Wall::plaster, 0xe0b06a, 0x2f5548},
    Plan{6.5, 4, 3, Ground::door, Top::stepped, Wall::brick, 0x9e604a, 0x1f3b34},
    Plan{8.0, 3, 3, Ground::arcade, Top::flat, Wall::plaster, 0xe9dcc0, 0x6b4a32},
    Plan{9.5, 4, 4, Ground::cafe, Top::mansard, Wall::plaster, 0xd9927a, 0x7c2f28, false, true},
    Plan{6.0, 4, 2, Ground::door, Top::bell, Wall::brick, 0x8a5142, 0x24405c},
    Plan{9.0, 3, 4, Ground::shop, Top::eaves, Wall::plaster, 0x9fb2a2, 0xb5542f},
    Plan{7.5, 4, 3, Ground::door, Top::pediment, Wall::plaster, 0xf0e2bd, 0x30505e, true},
    Plan{6.5, 4, 2, Ground::shop, Top::stepped, Wall::brick, 0xb87a4e, 0x28352f},
    Plan{8.0, 3, 3, Ground::door, Top::eaves, Wall::brick, 0x94584a, 0x2c4a3b, true, false, 1.6},
    Plan{10.0, 4, 4, Ground::arcade, Top::mansard, Wall::plaster, 0xecd7a4, 0x4a3a30, true, true},
    Plan{6.0, 4, 2, Ground::door, Top::bell, Wall::plaster, 0xc9745a, 0x273b52},
    Plan{8.5, 3, 3, Ground::shop, Top::flat, Wall::brick, 0xaf6a4a, 0x8a2f2a},
    Plan{7.5, 5, 3, Ground::door, Top::eaves, Wall::plaster, 0xa9b7be, 0x6b2c28, false, true},
    Plan{11.0, 4, 4, Ground::shop, Top::pediment, Wall::plaster, 0xe6c07c, 0x2f4a3c, true},
};

constexpr std::array south{
    Plan{9.0, 4, 4, Ground::shop, Top::mansard, Wall::plaster, 0xd8c7a6, 0x8a3b2a, false, true},
    Plan{6.5, 4, 2, Ground::door, Top::bell, Wall::brick, 0x9a5540, 0x294a52},
    Plan{7.5, 3, 3, Ground::shop, Top::eaves, Wall::plaster, 0xe3b28a, 0x37563f},
    Plan{8.0, 4, 3, Ground::door, Top::flat, Wall::plaster, 0xc6cfc8, 0x40332c, true},
    Plan{6.0, 4, 2, Ground::shop, Top::stepped, Wall::brick, 0x8c4434, 0xc08a2c},
    Plan{10.5, 3, 4, Ground::arcade, Top::eaves, Wall::plaster, 0xefe4c6, 0x5a3b2c, true},
    Plan{7.0, 4, 3, Ground::door, Top::pediment, Wall::brick, 0xa9684c, 0x23443f},
    Plan{8.5, 4, 3, Ground::shop, Top::mansard, Wall::plaster, 0xb9c4cc, 0x803028, false, true},
    Plan{6.5, 4, 3, Ground::door, Top::stepped, Wall::brick, 0xb0714c, 0x2b3f5b},
    Plan{8.0, 3, 3, Ground::door, Top::eaves, Wall::brick, 0x8f5344, 0x314c39, false, false, 1.6},
    Plan{9.5, 4, 4, Ground::cafe, Top::flat, Wall::plaster, 0xe7cf98, 0x2d5a55, true},
    Plan{6.0, 4, 2, Ground::door, Top::bell, Wall::plaster, 0xcf8d78, 0x2f2f38},
    Plan{9.0, 3, 4, Ground::shop, Top::eaves, Wall::plaster, 0xd9d2c0, 0xa84f2d},
    Plan{10.0, 4, 4, Ground::arcade, Top::pediment, Wall::brick, 0xa45c42, 0x2b4a44, true},
};

// One tile of brickwork: 4 bricks wide, 12 courses high, 0.88 by 0.84 m.
Color brickwork(const Sample& sample) {
    const V2d at((sample.point.x / 1.0 + 1.0) * 2.0, (sample.point.y + 1.0) * 6.0);
    const int course = static_cast<int>(std::floor(at.y));
    const double shifted = at.x + 0.5 * (course % 2);
    const int brick = static_cast<int>(std::floor(shifted)) % 4;
    const double to_side = std::fabs(shifted - std::floor(shifted) - 0.5);
    const double to_bed = std::fabs(at.y - course - 0.5);
    if (to_side > 0.475 || to_bed > 0.42) {
        return Color(0.95, 0.93, 0.9);
    }
    return Color(0.72 + 0.36 * lattice_noise(brick, course, 5));
}

// Setts of 0.125 m in rows, 2 by 2 m.
Color setts(const Sample& sample) {
    const V2d at = (sample.point + V2d(1.0)) * 8.0;
    const int row = static_cast<int>(std::floor(at.y));
    const double shifted = at.x + 0.5 * (row % 2);
    const int column = static_cast<int>(std::floor(shifted)) % 16;
    const double x = std::fabs(shifted - std::floor(shifted) - 0.5);
    const double y = std::fabs(at.y - row - 0.5);
    const double stone = 1.0 - smooth_step(0.3, 0.48, std::max(x, y));
    return Color(0.16, 0.15, 0.14) +
           Color(0.2, 0.19, 0.18) * stone * (0.55 + 0.9 * lattice_noise(column, row, 8));
}

// Slabs of half a metre, 2 by 2 m.
Color slabs(const Sample& sample) {
    const V2d at = (sample.point + V2d(1.0)) * 2.0;
    const int column = static_cast<int>(std::floor(at.x));
    const int row = static_cast<int>(std::floor(at.y));
    const V2d in(at.x - column, at.y - row);
    const double joint = smooth_step(0.0, 0.05, std::min({in.x, 1.0 - in.x, in.y, 1.0 - in.y}));
    return Color(0.46, 0.43, 0.39) * (0.8 + 0.3 * lattice_noise(column, row, 12)) *
           (0.6 + 0.4 * joint);
}

// Rows of tiles, 1 by 1 m.
Color roof_tiles(const Sample& sample) {
    const V2d at((sample.point.x + 1.0) * 2.5, (sample.point.y + 1.0) * 2.0);
    const int row = static_cast<int>(std::floor(at.y));
    const int column = static_cast<int>(std::floor(at.x));
    const double edge = smooth_step(0.0, 0.25, at.y - row);
    return Color(0.75 + 0.3 * lattice_noise(column, row, 14)) * (0.6 + 0.4 * edge);
}

scene::TextureUse tiled(SceneBuilder& builder, const char* name, const Painter& painter, int pixels,
                        double width, double height) {
    scene::TextureUse use{.index = builder.texture(name, pixels, pixels, painter),
                          .encoding = scene::TextureEncoding::srgb};
    use.u_axis = scene::V2f(static_cast<float>(1.0 / width), 0.0F);
    use.v_axis = scene::V2f(0.0F, static_cast<float>(1.0 / height));
    return use;
}

class Street {
public:
    explicit Street(const SceneOptions& options) : builder_("street", options) {}

    Result<scene::Scene> build() && {
        const Stock stock = make_stock(builder_);
        add_ground(stock);
        for (const Lot& lot : lots()) {
            add(stock, lot);
        }
        add_furniture(builder_, stock);
        return std::move(builder_).finish();
    }

private:
    void add(const Stock& stock, const Lot& lot) {
        const Plan& plan = (lot.north ? north : south)[static_cast<std::size_t>(lot.number - 1)];
        const double y = half_width + plan.set_back;
        const M44d placed = lot.north ? M44d().setTranslation(V3d(lot.x, y, 0.0))
                                      : M44d().setAxisAngle(V3d(0, 0, 1), std::numbers::pi) *
                                            M44d().setTranslation(V3d(lot.x + lot.width, -y, 0.0));
        add_house(builder_, stock,
                  fmt::format("{} house {}", lot.north ? "north" : "south", lot.number), plan,
                  placed);
    }

    void add_ground(const Stock& stock) {
        const double curb = 4.4;
        const auto put = [&](const char* name, const MeshBuilder& built, MaterialIndex material) {
            builder_.place(name, builder_.mesh(name, built.mesh(), material));
        };
        const double west = -60.0;
        const double east = length + 60.0;
        put("roadway",
            MeshBuilder().quad(V3d(west, -curb, 0), V3d(east, -curb, 0), V3d(east, curb, 0),
                               V3d(west, curb, 0)),
            stock.road);
        MeshBuilder walks, curbs, rails, stripes;
        for (const double side : {1.0, -1.0}) {
            const double near = side > 0 ? curb + 0.2 : -half_width - 12.0;
            const double far = side > 0 ? half_width + 12.0 : -curb - 0.2;
            walks.quad(V3d(west, near, 0.13), V3d(east, near, 0.13), V3d(east, far, 0.13),
                       V3d(west, far, 0.13));
            const double from = side > 0 ? curb : -curb - 0.2;
            for (double x = west; x < east; x += 1.0) {
                curbs.box(V3d(x, from, -0.1), V3d(x + 0.985, from + 0.2, 0.14), 0.02);
            }
            for (const double gauge : {-0.72, 0.72}) {
                const double y = side * 1.75 + gauge;
                rails.box(V3d(west, y - 0.045, -0.05), V3d(east, y + 0.045, 0.006));
            }
        }
        for (int i = 0; i < 10; ++i) {
            const double y = -4.05 + 0.9 * i;
            stripes.box(V3d(69.0, y - 0.27, -0.05), V3d(72.4, y + 0.27, 0.008));
        }
        put("pavements", walks, stock.walk);
        put("curbs", curbs, stock.stone);
        scene::Material steel;
        steel.name = "rails";
        steel.base_color = tint(0x6a6460);
        steel.metallic = 1.0F;
        steel.roughness = 0.35F;
        put("rails", rails, builder_.material(steel));
        put("zebra crossing", stripes, builder_.material("road paint", tint(0xe6e2d8), 0.7F));
    }

    SceneBuilder builder_;
};

}  // namespace

std::span<const Lot> lots() {
    static const std::vector<Lot> all = [] {
        std::vector<Lot> made;
        for (const bool is_north : {true, false}) {
            double x = 0.0;
            int number = 0;
            for (const Plan& plan : is_north ? north : south) {
                made.push_back({is_north, ++number, x, plan.width});
                x += plan.width;
            }
        }
        return made;
    }();
    return all;
}

Stock make_stock(SceneBuilder& builder) {
    Stock stock;
    stock.brick = tiled(builder, "brickwork", brickwork, 192, 0.88, 0.84);
    stock.plaster = tiled(
        builder, "plaster",
        [](const Sample& s) { return Color(0.95 + 0.04 * fractal_noise(s.point * 3.0, 4, 3)); },
        128, 4.0, 4.0);
    stock.tiles = tiled(builder, "roof tiles", roof_tiles, 128, 1.0, 1.0);
    const auto tiled_roof = [&](const char* name, std::uint32_t color, float roughness) {
        scene::Material material;
        material.name = name;
        material.base_color = tint(color);
        material.base_color_texture = stock.tiles;
        material.roughness = roughness;
        return builder.material(material);
    };
    const auto paved = [&](const char* name, const Painter& painter, float roughness) {
        scene::Material material;
        material.name = name;
        material.base_color = scene::Color3f(1.0F);
        material.base_color_texture = tiled(builder, name, painter, 256, 2.0, 2.0);
        material.roughness = roughness;
        return builder.material(material);
    };
    stock.road = paved("setts", setts, 0.6F);
    stock.walk = paved("slabs", slabs, 0.8F);
    stock.stone = builder.material("sandstone", tint(0xe6dcc6), 0.85F);
    stock.paint = builder.material("white paint", tint(0xf1eee6), 0.5F);
    stock.clay = tiled_roof("clay tiles", 0xb0583a, 0.85F);
    stock.slate = tiled_roof("slates", 0x6f7880, 0.5F);
    stock.iron = builder.material("wrought iron", tint(0x26282a), 0.5F);
    stock.leaves = builder.material("geranium leaves", tint(0x4f6b35), 0.8F);
    stock.flowers = builder.material("geraniums", tint(0xc4372c), 0.7F);
    stock.curtain = builder.material("curtains", tint(0xcfc8ba), 0.25F);
    stock.glass = builder.material("window glass", tint(0x1c242b), 0.04F);
    scene::Material side;
    side.name = "party walls";
    side.base_color = tint(0xb59a85);
    side.base_color_texture = stock.brick;
    stock.sides = builder.material(side);
    scene::Material light;
    light.name = "lamplight";
    light.base_color = tint(0x3a2c1c);
    light.roughness = 0.1F;
    light.emission = scene::Color3f(1.0F, 0.38F, 0.07F) * 3600.0F;
    stock.lamplight = builder.material(light);
    return stock;
}

}  // namespace street

Result<scene::Scene> make_street(const SceneOptions& options) {
    return street::Street(options).build();
}

}  // namespace balcony::plates
