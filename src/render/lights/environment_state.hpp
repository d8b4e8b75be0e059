// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/environment.hpp"
#include "render/lights/environment_map.hpp"

namespace balcony::render {

struct Environment::State {
    std::shared_ptr<const EnvironmentMap> map;
    double rotation = 0.0;  ///< Radians.
    float strength = 1.0F;
};

}  // namespace balcony::render
