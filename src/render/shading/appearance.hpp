// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// glTF 2.0's metallic-roughness material at a point.

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include "balcony/scene.hpp"
#include "render/textures/texture_library.hpp"

namespace balcony::render {

using Imath::Color3f;
using Imath::V3f;

/// A material with its textures evaluated.
struct Appearance {
    Color3f base_color;
    Color3f emission;
    float opacity = 1.0F;
    float metallic = 0.0F;
    float roughness = 1.0F;
};

[[nodiscard]] bool has_textures(const scene::Material& material);

[[nodiscard]] Appearance look_up(const scene::Material& material, const TextureLibrary& textures,
                                 const TextureFootprint& footprint,
                                 TextureLibrary::ThreadCache cache);

/// The opacity only, after the alpha mask and according to the mode.
[[nodiscard]] float look_up_opacity(const scene::Material& material, const TextureLibrary& textures,
                                    const TextureFootprint& footprint,
                                    TextureLibrary::ThreadCache cache);

}  // namespace balcony::render
