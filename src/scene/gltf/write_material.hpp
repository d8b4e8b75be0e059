// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "balcony/scene.hpp"

namespace balcony::scene {

/// A material as glTF's JSON; adds the extensions that it uses. What glTF cannot express is left
/// out: opacity that is not the alpha of the base colour's texture, and metallic and roughness in
/// different textures.
[[nodiscard]] nlohmann::json gltf_material(const Material& material,
                                           std::set<std::string>& extensions);

}  // namespace balcony::scene
