// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/render.hpp"
#include "render/tracing/scene_tracer.hpp"

namespace balcony::render {

struct Renderer::State {
    TracedScene traced;
    Preparation preparation;
    bool textures_on_demand = false;
};

}  // namespace balcony::render
