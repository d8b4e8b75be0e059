// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "scene/gltf/gltf_materials.hpp"

namespace balcony::scene {

namespace {

void read_clearcoat(const Json& json, GltfMaterialReader& reader) {
    Material& m = reader.material;
    m.clearcoat = reader.unit_interval(json, "clearcoatFactor", 0.0F);
    m.clearcoat_roughness = reader.unit_interval(json, "clearcoatRoughnessFactor", 0.0F);
    reader.read_texture(json, "clearcoatTexture", Channel::red, m.clearcoat_texture);
    reader.read_texture(json, "clearcoatRoughnessTexture", Channel::green,
                        m.clearcoat_roughness_texture);
    m.clearcoat_normal_scale =
        signed_quantity_in(member(json, "clearcoatNormalTexture"), "scale", 1.0F);
    reader.read_texture(json, "clearcoatNormalTexture", m.clearcoat_normal_texture);
}

void read_emissive_strength(const Json& json, GltfMaterialReader& reader) {
    Color3f& emission = reader.material.emission;
    emission = scaled(emission, quantity_in(json, "emissiveStrength", 1.0F), "emissiveStrength");
}

// An index of 0 stands for a reflectance of 1 at normal incidence.
void read_ior(const Json& json, GltfMaterialReader& reader) {
    const double ior = number_in(json, "ior", 1.5);
    if (ior != 0.0 && ior < 1.0) {
        throw PartError{"its 'ior' is less than 1"};
    }
    reader.material.ior =
        static_cast<float>(ior == 0.0 ? max_refraction_index : std::min(ior, max_refraction_index));
}

void read_sheen(const Json& json, GltfMaterialReader& reader) {
    Material& m = reader.material;
    m.sheen_color = color_in(json, "sheenColorFactor", Color3f(0.0F));
    m.sheen_roughness = reader.unit_interval(json, "sheenRoughnessFactor", 0.0F);
    reader.read_texture(json, "sheenColorTexture", m.sheen_color_texture);
    reader.read_texture(json, "sheenRoughnessTexture", Channel::alpha, m.sheen_roughness_texture);
}

void read_specular(const Json& json, GltfMaterialReader& reader) {
    Material& m = reader.material;
    m.specular = reader.unit_interval(json, "specularFactor", 1.0F);
    m.specular_color = color_in(json, "specularColorFactor", Color3f(1.0F));
    reader.read_texture(json, "specularTexture", Channel::alpha, m.specular_texture);
    reader.read_texture(json, "specularColorTexture", m.specular_color_texture);
}

void read_transmission(const Json& json, GltfMaterialReader& reader) {
    Material& m = reader.material;
    m.transmission = reader.unit_interval(json, "transmissionFactor", 0.0F);
    reader.read_texture(json, "transmissionTexture", Channel::red, m.transmission_texture);
}

void read_unlit(const Json&, GltfMaterialReader& reader) { reader.material.unlit = true; }

// Light that travels a distance d in the volume keeps attenuationColor^(d / attenuationDistance),
// which is exp(-absorption d). Rays find the thickness themselves; the factor only states whether
// there is a volume.
void read_volume(const Json& json, GltfMaterialReader& reader) {
    const double distance =
        number_in(json, "attenuationDistance", std::numeric_limits<double>::infinity());
    if (!(distance > 0.0)) {
        throw PartError{"its 'attenuationDistance' is not positive"};
    }
    const Color3f color = color_in(json, "attenuationColor", Color3f(1.0F));
    // Black is what keeps a millionth.
    const auto absorption = [distance](float kept) {
        const double part = std::clamp(double{kept}, 1e-6, 1.0);
        return static_cast<float>(std::min(std::log(1.0 / part) / distance, max_quantity));
    };
    reader.material.thin_walled = quantity_in(json, "thicknessFactor", 0.0F) == 0.0F;
    reader.material.absorption = {absorption(color.x), absorption(color.y), absorption(color.z)};
}

constexpr std::array material_extensions{
    GltfMaterialExtension{"KHR_materials_clearcoat", read_clearcoat},
    GltfMaterialExtension{"KHR_materials_emissive_strength", read_emissive_strength},
    GltfMaterialExtension{"KHR_materials_ior", read_ior},
    GltfMaterialExtension{"KHR_materials_sheen", read_sheen},
    GltfMaterialExtension{"KHR_materials_specular", read_specular},
    GltfMaterialExtension{"KHR_materials_transmission", read_transmission},
    GltfMaterialExtension{"KHR_materials_unlit", read_unlit},
    GltfMaterialExtension{"KHR_materials_volume", read_volume}};

}  // namespace

std::span<const GltfMaterialExtension> gltf_material_extensions() { return material_extensions; }

}  // namespace balcony::scene
