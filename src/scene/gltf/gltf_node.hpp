// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "balcony/motion.hpp"
#include "scene/gltf/gltf_json.hpp"

namespace balcony::scene {

/// The translation, rotation (of length 1) and scale of a node without a matrix. Throws PartError.
struct GltfTransform {
    explicit GltfTransform(const Json& node);

    V3d translation, scale;
    Quatd rotation;
};

/// A node's own transform, by its matrix or its parts. Throws PartError.
[[nodiscard]] M44d local_transform(const Json& node);

/// The name of a node for messages.
[[nodiscard]] std::string node_name(const Json& node, std::size_t index);

}  // namespace balcony::scene
