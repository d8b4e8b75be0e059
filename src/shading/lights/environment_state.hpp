// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "balcony/environment.hpp"
#include "shading/lights/environment_map.hpp"
#include "shading/lights/sun.hpp"

namespace balcony::render {

struct Environment::State {
    std::shared_ptr<const EnvironmentMap> map;
    std::vector<Sun> suns{};    ///< In the directions of the map.
    std::string description{};  ///< Completes "lit by": "a sky ...".
    double rotation = 0.0;      ///< Radians.
    float strength = 1.0F;
};

}  // namespace balcony::render
