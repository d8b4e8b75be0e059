// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>

#include "balcony/motion.hpp"

namespace balcony::scene {

namespace {

// The normals of transformed surfaces are those of the matrix of cofactors, the inverse transpose
// but for its length.
V3d transformed_normal(const V3d& normal, const M44d& m) {
    const V3d x(m[0][0], m[0][1], m[0][2]);
    const V3d y(m[1][0], m[1][1], m[1][2]);
    const V3d z(m[2][0], m[2][1], m[2][2]);
    return normal.x * y.cross(z) + normal.y * z.cross(x) + normal.z * x.cross(y);
}

// A unit vector, or the one that stood here before if there is no direction.
V3f unit_or(const V3d& vector, const V3f& before) {
    const double length = vector.length();
    return length > 0.0 && std::isfinite(length) ? V3f(vector / length) : before;
}

void morph(const Motion& motion, const Deformation& deformation, double time, Shape& shape) {
    std::vector<double> weights(deformation.weights.begin(), deformation.weights.end());
    if (deformation.weights_track.valid()) {
        evaluate(motion.tracks[deformation.weights_track.value()], time, weights);
    }
    for (std::size_t i = 0; i < deformation.targets.size(); ++i) {
        const MorphTarget& target = deformation.targets[i];
        const auto weight = static_cast<float>(weights[i]);
        for (std::size_t v = 0; weight != 0.0F && v < target.positions.size(); ++v) {
            shape.positions[v] += weight * target.positions[v];
        }
        for (std::size_t v = 0; weight != 0.0F && v < target.normals.size(); ++v) {
            shape.normals[v] += weight * target.normals[v];
        }
    }
}

// glTF 2.0, section 3.7.3.3.
void skin(const Motion& motion, const Deformation& deformation, double time, Shape& shape) {
    std::vector<M44d> world_from_mesh;
    for (const Joint& joint : deformation.joints) {
        world_from_mesh.push_back(joint.joint_from_mesh *
                                  world_from_node(motion, joint.node, time));
    }
    const std::size_t count = deformation.influences.size() / shape.positions.size();
    for (std::size_t v = 0; v < shape.positions.size(); ++v) {
        M44d blended(0.0);
        for (std::size_t i = 0; i < count; ++i) {
            const Influence& influence = deformation.influences[v * count + i];
            if (influence.weight != 0.0F) {
                blended += static_cast<double>(influence.weight) * world_from_mesh[influence.joint];
            }
        }
        blended[3][3] = 1.0;
        shape.positions[v] = V3f(V3d(shape.positions[v]) * blended);
        shape.normals[v] = V3f(transformed_normal(V3d(shape.normals[v]), blended).normalized());
    }
}

void set_flat_normals(const std::vector<std::array<std::uint32_t, 3>>& triangles, Shape& shape) {
    for (const auto& triangle : triangles) {
        const V3d a(shape.positions[triangle[0]]);
        const V3d across =
            (V3d(shape.positions[triangle[1]]) - a).cross(V3d(shape.positions[triangle[2]]) - a);
        for (const std::uint32_t vertex : triangle) {
            shape.normals[vertex] = unit_or(across, shape.normals[vertex]);
        }
    }
}

}  // namespace

Shape shape_at(const Motion& motion, const Deformation& deformation, double time) {
    Shape shape{deformation.positions, deformation.normals};
    morph(motion, deformation, time, shape);
    if (!deformation.joints.empty()) {
        skin(motion, deformation, time, shape);
    }
    if (!deformation.flat.empty()) {
        set_flat_normals(deformation.flat, shape);
    }
    for (std::size_t v = 0; v < shape.normals.size(); ++v) {
        shape.normals[v] = unit_or(V3d(shape.normals[v]), deformation.normals[v]);
    }
    return shape;
}

}  // namespace balcony::scene
