// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <Imath/ImathBox.h>

#include "balcony/scene.hpp"

namespace balcony::render {

/// The bounds of a scene without its surroundings: up to three objects that are much larger than
/// all others together, and flat like a ground, or around the others like a sky. Nothing if there
/// are none.
[[nodiscard]] std::optional<Imath::Box3d> box_of_main_objects(const scene::Scene& scene);

}  // namespace balcony::render
