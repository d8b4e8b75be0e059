// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/gltf/gltf_node.hpp"

#include <cmath>

#include <fmt/format.h>

namespace balcony::scene {

namespace {

// glTF 2.0, section 3.5.3: matrices have no perspective. Writers may round the values 0 and 1.
M44d affine(M44d matrix) {
    constexpr double rounding = 1e-6;
    const bool is_affine =
        std::abs(matrix[0][3]) <= rounding && std::abs(matrix[1][3]) <= rounding &&
        std::abs(matrix[2][3]) <= rounding && std::abs(matrix[3][3] - 1.0) <= rounding;
    if (!is_affine) {
        throw PartError{"its 'matrix' is not affine: the last row must be 0, 0, 0, 1"};
    }
    matrix[0][3] = matrix[1][3] = matrix[2][3] = 0.0;
    matrix[3][3] = 1.0;
    return matrix;
}

V3d vector_in(const Json& node, const char* key, double fallback) {
    const auto numbers = numbers_in(node, key, {fallback, fallback, fallback});
    return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace

GltfTransform::GltfTransform(const Json& node)
    : translation(vector_in(node, "translation", 0.0)), scale(vector_in(node, "scale", 1.0)) {
    const auto turn = numbers_in(node, "rotation", {0.0, 0.0, 0.0, 1.0});
    rotation = Quatd(turn[3], turn[0], turn[1], turn[2]);
    if (!(rotation.length() > 0.0 && std::isfinite(rotation.length()))) {
        throw PartError{"its 'rotation' has length 0"};
    }
    rotation.normalize();
}

// glTF stores matrices for column vectors column by column, which read row by row is the matrix for
// row vectors.
M44d local_transform(const Json& node) {
    if (member(node, "matrix").is_null()) {
        const GltfTransform parts(node);
        return transform_of(parts.translation, parts.rotation, parts.scale);
    }
    const auto numbers = numbers_in(node, "matrix", std::vector<double>(16, 0.0));
    M44d local;
    for (std::size_t i = 0; i < 16; ++i) {
        local[static_cast<int>(i / 4)][i % 4] = numbers[i];
    }
    return affine(local);
}

std::string node_name(const Json& node, std::size_t index) {
    const std::string name = text_in(node, "name");
    return name.empty() ? fmt::format("node {}", index) : name;
}

}  // namespace balcony::scene
