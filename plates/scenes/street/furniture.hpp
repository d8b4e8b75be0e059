// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What stands in streets.

#include <vector>

#include "common/mesh_builder.hpp"
#include "common/scene_builder.hpp"
#include "scenes/street/house.hpp"

namespace balcony::plates::street {

/// Things of a street, each placed any number of times: the foot at the origin, z up. Numbered in
/// their names in the order in which they are placed; their colours change from one to the next.
class Furniture {
public:
    /// The builder must outlive it.
    Furniture(SceneBuilder& builder, const Stock& stock);

    void tree(const M44d& placed);
    void lamp(const M44d& placed);
    void bicycle(const M44d& placed);  ///< Along x, parked.
    void table(const M44d& placed);    ///< Of a café, with chairs and a parasol.
    void cyclist(const M44d& placed);  ///< Rides along x.
    void person(const M44d& placed);   ///< Walks along x.

private:
    SceneBuilder& builder_;
    std::vector<scene::MeshIndex> crowns_, bicycles_, coats_;
    scene::MeshIndex trunk_, post_, lantern_, parasol_, table_, head_, ridden_;
    int trees_ = 0, lamps_ = 0, parked_ = 0, tables_ = 0, cyclists_ = 0, people_ = 0;
};

/// Trees, lamps, bicycles, a tram, people and café tables of the street of plate 20.
void add_furniture(SceneBuilder& builder, const Stock& stock);

}  // namespace balcony::plates::street
