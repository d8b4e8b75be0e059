// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the direct integrator shows as a mirror.

#include "balcony/scene.hpp"

namespace balcony::render {

/// Surfaces with a roughness below this are perfect mirrors: without other samples, rays cannot
/// show what a glossy surface reflects.
inline constexpr float mirror_roughness = 0.1F;

/// Whether a point with this material can be a mirror; a texture only reduces the roughness.
[[nodiscard]] bool may_be_mirror(const scene::Material& material);

}  // namespace balcony::render
