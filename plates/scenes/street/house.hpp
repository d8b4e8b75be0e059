// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Town houses: a front with windows, a ground floor, and what is on top.

#include <array>
#include <cstdint>
#include <string>

#include "common/mesh_builder.hpp"
#include "common/scene_builder.hpp"

namespace balcony::plates::street {

enum class Ground : std::uint8_t { door, shop, cafe, arcade };
enum class Top : std::uint8_t { eaves, stepped, bell, pediment, mansard, flat };
enum class Wall : std::uint8_t { brick, plaster };

struct Plan {
    double width;
    int storeys;  ///< Including the ground floor.
    int windows;  ///< In each upper storey.
    Ground ground;
    Top top;
    Wall wall;
    std::uint32_t color;   ///< sRGB, of the front.
    std::uint32_t accent;  ///< sRGB, of door, shop front and awning.
    bool arched = false;   ///< The windows.
    bool balcony = false;  ///< Before the first floor.
    double set_back = 0.0;
};

/// Materials that all houses and streets share.
struct Stock {
    scene::TextureUse brick, plaster, tiles;
    scene::MaterialIndex stone, paint, glass, curtain, lamplight, slate, clay, iron, sides, leaves,
        flowers;
    scene::MaterialIndex road, walk;  ///< Of the ground.
};

[[nodiscard]] Stock make_stock(SceneBuilder& builder);

/// Its front stands on the x axis from 0 to its width and faces -y. Objects are named after it:
/// "NAME front", "NAME roof", ...
void add_house(SceneBuilder& builder, const Stock& stock, const std::string& name, const Plan& plan,
               const M44d& placed);

}  // namespace balcony::plates::street
