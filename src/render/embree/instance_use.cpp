// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/embree/instance_use.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "render/embree/accelerator.hpp"

namespace balcony::render::embree {

namespace {

// Whether a matrix is finite and affine, so that it maps finite points to finite points.
bool is_affine(const scene::M44d& m) {
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 3; ++column) {
            if (!std::isfinite(m[row][column])) {
                return false;
            }
        }
    }
    return m[0][3] == 0.0 && m[1][3] == 0.0 && m[2][3] == 0.0 && m[3][3] == 1.0;
}

// The largest coordinate in the image of the unit cube under a linear map.
double norm(const scene::M44d& m) {
    double maximum = 0.0;
    for (int column = 0; column < 3; ++column) {
        maximum = std::max(
            maximum, std::abs(m[0][column]) + std::abs(m[1][column]) + std::abs(m[2][column]));
    }
    return maximum;
}

// The largest coordinate of a mesh; nothing if one of them is out of range.
std::optional<double> extent(const scene::Mesh& mesh) {
    float largest = 0.0F;
    for (const V3f& p : mesh.positions) {
        if (!in_range(p)) {
            return std::nullopt;
        }
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    return largest;
}

// Whether the whole mesh, whose own coordinates are in range, can be traced as placed. Most are so
// far from the limit that a bound decides.
bool can_be_traced(const scene::Mesh& mesh, double largest, const scene::M44d& world_from_mesh) {
    if (!is_affine(world_from_mesh)) {
        return false;
    }
    const scene::V3d shift = world_from_mesh.translation();
    const double bound = norm(world_from_mesh) * largest +
                         std::max({std::abs(shift.x), std::abs(shift.y), std::abs(shift.z)});
    constexpr double rounding = 0.9;
    return bound <= rounding * max_coordinate ||
           std::all_of(mesh.positions.begin(), mesh.positions.end(),
                       [&](const V3f& p) { return in_range(scene::V3d(p) * world_from_mesh); });
}

}  // namespace

std::optional<double> reach_into(const scene::M44d& world_from_mesh) {
    constexpr double max_scale = 1e6;
    constexpr double max_condition = 1e3;  // Its square times a float's rounding is below 0.1.
    constexpr double min_reach = 1e12;
    if (world_from_mesh.determinant() == 0.0) {
        return std::nullopt;
    }
    const scene::M44d mesh_from_world = world_from_mesh.inverse();
    const double scale = norm(world_from_mesh);
    const double inverse_scale = norm(mesh_from_world);
    if (!(scale <= max_scale && inverse_scale <= max_scale &&
          scale * inverse_scale <= max_condition)) {
        return std::nullopt;
    }
    const scene::V3d shift = mesh_from_world.translation();
    const double largest_shift =
        std::max({std::abs(shift.x), std::abs(shift.y), std::abs(shift.z)});
    constexpr double rounding = 0.9;
    const double reach = (rounding * max_coordinate - largest_shift) / inverse_scale;
    return reach >= min_reach ? std::optional(reach) : std::nullopt;
}

std::vector<Use> choose_uses(const scene::Scene& scene, const MotionSteps& motion) {
    std::vector<std::size_t> counts(scene.meshes.size());
    std::vector<Use> uses(scene.instances.size(), Use::none);
    std::vector<std::optional<double>> extents(scene.meshes.size());
    std::transform(scene.meshes.begin(), scene.meshes.end(), extents.begin(), extent);
    for (std::size_t i = 0; i < uses.size(); ++i) {
        const scene::Instance& instance = scene.instances[i];
        const scene::Mesh& mesh = scene.meshes[instance.mesh.value()];
        const auto steps = motion.matrices(i);
        const std::optional<double> largest = extents[instance.mesh.value()];
        if (largest &&
            std::all_of(steps.begin(), steps.end(), [&](const scene::M44d& world_from_mesh) {
                return can_be_traced(mesh, *largest, world_from_mesh);
            })) {
            uses[i] = Use::copied;
            ++counts[instance.mesh.value()];
        }
    }
    for (std::size_t i = 0; i < uses.size(); ++i) {
        const auto steps = motion.matrices(i);
        const bool is_shared = counts[scene.instances[i].mesh.value()] > 1 || steps.size() > 1;
        if (uses[i] == Use::copied && is_shared &&
            std::all_of(steps.begin(), steps.end(), reach_into)) {
            uses[i] = Use::placed;
        }
    }
    return uses;
}

Diagnostics name_left_out(const scene::Scene& scene, const std::vector<Use>& uses) {
    std::set<std::uint32_t> objects;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        if (uses[i] == Use::none) {
            objects.insert(scene.instances[i].object);
        }
    }
    Diagnostics warnings;
    for (const std::uint32_t object : objects) {
        warnings.push_back(warning(
            fmt::format("object '{}' extends beyond {:.3g} or is placed by a matrix that is not "
                        "affine; it is skipped",
                        scene.objects[object].name, max_coordinate),
            {}, "scale the scene down, or repair its transforms"));
    }
    return warnings;
}

}  // namespace balcony::render::embree
