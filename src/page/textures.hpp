// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <set>

#include <nlohmann/json_fwd.hpp>

#include "balcony/scene.hpp"
#include "page/blob.hpp"

namespace balcony::page {

/// Those of a material that its preview is made of: base colour, opacity, emission, normals.
[[nodiscard]] std::array<const scene::TextureUse*, 4> shown_uses(const scene::Material& material);

/// All that the preview of a scene needs.
[[nodiscard]] std::set<scene::TextureIndex> shown_textures(const scene::Scene& scene);

/// Adds textures as PNG, JPEG or WebP files with sides of up to `side` pixels. Each is an object
/// with its place in the blob, in the order of the set, or null, with a warning, if it cannot be
/// read.
[[nodiscard]] Result<nlohmann::json> add_textures(const scene::Scene& scene,
                                                  const std::set<scene::TextureIndex>& textures,
                                                  std::size_t side, Blob& blob);

}  // namespace balcony::page
