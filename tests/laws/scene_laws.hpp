// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What scene.hpp promises of every scene that load() returns.

#include <algorithm>
#include <cmath>
#include <string>

#include "balcony/scene.hpp"

namespace balcony::laws {

inline bool is_within(const scene::V3d& point, double maximum) {
    return std::abs(point.x) <= maximum && std::abs(point.y) <= maximum &&
           std::abs(point.z) <= maximum;
}

inline bool is_light(const scene::Color3f& color) {
    return color.x >= 0.0F && color.y >= 0.0F && color.z >= 0.0F &&
           is_within(scene::V3d(color), scene::max_quantity);
}

/// The promise that a mesh breaks; empty if it breaks none.
inline std::string broken_law(const scene::Mesh& mesh, const scene::Scene& scene) {
    const std::size_t count = mesh.positions.size();
    if (mesh.triangles.empty()) {
        return "a mesh has no triangles";
    }
    if (mesh.normals.size() != count ||
        (!mesh.texture_coordinates.empty() && mesh.texture_coordinates.size() != count)) {
        return "a mesh has normals or texture coordinates for some vertices only";
    }
    if (!mesh.material.valid() || mesh.material.value() >= scene.materials.size()) {
        return "a mesh has no material";
    }
    for (const auto& triangle : mesh.triangles) {
        if (std::any_of(triangle.begin(), triangle.end(),
                        [count](std::uint32_t vertex) { return vertex >= count; })) {
            return "a triangle has a vertex out of range";
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (!is_within(scene::V3d(mesh.positions[i]), scene::max_coordinate)) {
            return "a vertex is out of range";
        }
        // Single rounding.
        if (!(std::abs(mesh.normals[i].length() - 1.0F) < 1e-5F)) {
            return "a normal is not of unit length";
        }
    }
    for (const scene::V2f& point : mesh.texture_coordinates) {
        if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
            return "a texture coordinate is not finite";
        }
    }
    if (!mesh.colors.empty() && mesh.colors.size() != count) {
        return "a mesh has colours for some vertices only";
    }
    for (const scene::Color3f& color : mesh.colors) {
        if (!is_light(color) || !is_within(scene::V3d(color), 1.0)) {
            return "a colour is out of range";
        }
    }
    return {};
}

inline std::string broken_law(const scene::Instance& instance, const scene::Scene& scene) {
    if (!instance.mesh.valid() || instance.mesh.value() >= scene.meshes.size() ||
        instance.object >= scene.objects.size()) {
        return "an instance has no mesh or no object";
    }
    const scene::M44d& m = instance.world_from_mesh;
    if (m[0][3] != 0.0 || m[1][3] != 0.0 || m[2][3] != 0.0 || m[3][3] != 1.0) {
        return "a transform is not affine";
    }
    if (!std::isfinite(m.determinant()) || m.determinant() == 0.0) {
        return "a transform is not invertible";
    }
    for (const scene::V3f& position : scene.meshes[instance.mesh.value()].positions) {
        // A few roundings on top.
        if (!is_within(scene::V3d(position) * m, scene::max_coordinate * (1.0 + 1e-12))) {
            return "an instance is out of range";
        }
    }
    return {};
}

inline std::string broken_law(const scene::Light& light) {
    if (!is_within(light.position, scene::max_coordinate)) {
        return "a light is out of range";
    }
    // A few roundings of doubles.
    if (!(std::abs(light.direction.length() - 1.0) < 1e-14)) {
        return "a light's direction is not of unit length";
    }
    if (!is_light(light.intensity) || !(light.range >= 0.0F)) {
        return "a light's intensity or range is out of range";
    }
    return light.inner_cone >= 0.0F && light.inner_cone <= light.outer_cone
               ? ""
               : "a light's cones are not in their order";
}

inline std::string broken_law(const scene::Material& material, const scene::Scene& scene) {
    const auto is_part = [](float value) { return value >= 0.0F && value <= 1.0F; };
    if (!is_light(material.base_color) || !is_light(material.emission) ||
        !is_part(material.alpha) || !is_part(material.metallic) || !is_part(material.roughness)) {
        return "a material is out of range";
    }
    for (const scene::TextureIndex texture :
         {material.base_color_texture, material.emission_texture,
          material.metallic_roughness_texture}) {
        if (texture.valid() && texture.value() >= scene.textures.size()) {
            return "a material has a texture out of range";
        }
    }
    return {};
}

/// The promise that a scene breaks; empty if it breaks none.
inline std::string broken_law(const scene::Scene& scene) {
    std::string broken = scene.instances.empty() ? "there is nothing to render" : "";
    const auto check = [&](const std::string& found) { broken = broken.empty() ? found : broken; };
    for (const scene::Mesh& mesh : scene.meshes) {
        check(broken_law(mesh, scene));
    }
    for (const scene::Instance& instance : scene.instances) {
        check(broken_law(instance, scene));
    }
    for (const scene::Light& light : scene.lights) {
        check(broken_law(light));
    }
    for (const scene::Material& material : scene.materials) {
        check(broken_law(material, scene));
    }
    for (const scene::Texture& texture : scene.textures) {
        check(texture.file.empty() == texture.bytes.empty() ? "a texture has no image" : "");
    }
    return broken;
}

/// The same of what load() returns: a scene, or else an error.
inline std::string broken_law(const Result<scene::Scene>& loaded) {
    if (loaded) {
        return has_errors(loaded.diagnostics) ? "a scene with an error" : broken_law(*loaded);
    }
    return has_errors(loaded.diagnostics) ? "" : "neither a scene nor an error";
}

}  // namespace balcony::laws
