// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/render.hpp"
#include "render/tracing/scene_tracer.hpp"

namespace balcony::render {

/// Whether a scene is another at another time.
[[nodiscard]] bool has_parts_of(const scene::Scene& moved, const scene::Scene& scene);

struct Renderer::State {
    TracedScene traced;
    Preparation preparation;
    bool textures_on_demand = false;
};

}  // namespace balcony::render
