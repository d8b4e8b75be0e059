// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>

#include <nlohmann/json_fwd.hpp>

#include "balcony/scene.hpp"
#include "page/blob.hpp"

namespace balcony::page {

/// The meshes, instances and materials of a scene as an object, with their arrays in the blob.
/// Textures are numbered by their order in the set.
[[nodiscard]] nlohmann::json scene_data(const scene::Scene& scene,
                                        const std::set<scene::TextureIndex>& textures, Blob& blob);

}  // namespace balcony::page
