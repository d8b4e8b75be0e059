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

inline bool is_part(float value) { return value >= 0.0F && value <= 1.0F; }

/// The promise that a mesh breaks; empty if it breaks none.
inline std::string broken_law(const scene::Mesh& mesh, const scene::Scene& scene) {
    const std::size_t count = mesh.positions.size();
    if (mesh.triangles.empty()) {
        return "a mesh has no triangles";
    }
    const auto fits = [count](const auto& attribute) {
        return attribute.empty() || attribute.size() == count;
    };
    if (mesh.normals.size() != count || !fits(mesh.tangents) || !fits(mesh.colors) ||
        !std::all_of(mesh.texture_coordinates.begin(), mesh.texture_coordinates.end(), fits)) {
        return "a mesh has normals, coordinates or colours for some vertices only";
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
    for (const auto& coordinates : mesh.texture_coordinates) {
        for (const scene::V2f& point : coordinates) {
            if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
                return "a texture coordinate is not finite";
            }
        }
    }
    for (const scene::V4f& tangent : mesh.tangents) {
        const float length = scene::V3f(tangent.x, tangent.y, tangent.z).length();
        if (length != 0.0F && !(std::abs(length - 1.0F) < 1e-5F)) {
            return "a tangent is neither of unit length nor 0";
        }
    }
    for (const scene::Color4f& color : mesh.colors) {
        if (!is_part(color.r) || !is_part(color.g) || !is_part(color.b) || !is_part(color.a)) {
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
    for (const scene::V3f& position : scene.meshes[instance.mesh.value()]->positions) {
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
    for (const scene::Color3f& color :
         {material.base_color, material.emission, material.specular_color, material.absorption,
          material.sheen_color}) {
        if (!is_light(color)) {
            return "a material's colour is out of range";
        }
    }
    for (const float part : {material.alpha, material.metallic, material.roughness,
                             material.specular, material.transmission, material.clearcoat,
                             material.clearcoat_roughness, material.sheen_roughness}) {
        if (!is_part(part)) {
            return "a material is out of range";
        }
    }
    if (!(material.ior >= 1.0F && double{material.ior} <= scene::max_refraction_index) ||
        !(std::abs(double{material.normal_scale}) <= scene::max_quantity) ||
        !(std::abs(double{material.clearcoat_normal_scale}) <= scene::max_quantity)) {
        return "a material's index of refraction or its normal map is out of range";
    }
    for (const auto texture : scene::texture_uses) {
        const scene::TextureUse& use = material.*texture;
        if (use.valid() && (use.index.value() >= scene.textures.size() || use.channel > 3 ||
                            use.coordinates >= scene::max_coordinate_sets)) {
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
        check(texture.file.empty() == texture.bytes->empty() ? "a texture has no image" : "");
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
