// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/gltf/gltf_materials.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace balcony::scene {

namespace {

AlphaMode alpha_mode_of(const std::string& mode) {
    if (mode == "MASK") {
        return AlphaMode::mask;
    }
    return mode == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
}

}  // namespace

float unit_interval_in(const Json& value, std::string_view key, float fallback) {
    return static_cast<float>(std::clamp(number_in(value, key, double{fallback}), 0.0, 1.0));
}

void GltfMaterialReader::read(const Json& json) {
    read_factors(json);
    const Json& surface = member(json, "pbrMetallicRoughness");
    read_texture(surface, "baseColorTexture", material.base_color_texture);
    if (material.alpha_mode != AlphaMode::opaque) {
        material.opacity_texture = material.base_color_texture;
        material.opacity_texture.channel = Channel::alpha;
    }
    read_texture(surface, "metallicRoughnessTexture", Channel::green, material.roughness_texture);
    material.metallic_texture = material.roughness_texture;
    material.metallic_texture.channel = Channel::blue;
    read_texture(json, "emissiveTexture", material.emission_texture);
    read_texture(json, "normalTexture", material.normal_texture);
    read_extensions(json);
}

void GltfMaterialReader::read_factors(const Json& json) {
    material.name = text_in(json, "name");
    const Json& surface = member(json, "pbrMetallicRoughness");
    const auto base = numbers_in(surface, "baseColorFactor", {1.0, 1.0, 1.0, 1.0});
    material.base_color = to_color({base[0], base[1], base[2]}, "baseColorFactor");
    material.metallic = unit_interval_in(surface, "metallicFactor", 1.0F);
    material.roughness = unit_interval_in(surface, "roughnessFactor", 1.0F);
    material.alpha_mode = alpha_mode_of(text_in(json, "alphaMode", "OPAQUE"));
    if (material.alpha_mode != AlphaMode::opaque) {
        material.alpha = static_cast<float>(std::clamp(base[3], 0.0, 1.0));
    }
    if (material.alpha_mode == AlphaMode::mask) {
        material.alpha_cutoff = quantity_in(json, "alphaCutoff", 0.5F);
    }
    material.emission = color_in(json, "emissiveFactor", Color3f(0.0F));
    material.normal_scale = signed_quantity_in(member(json, "normalTexture"), "scale", 1.0F);
    material.double_sided = flag_in(json, "doubleSided");
}

void GltfMaterialReader::read_extensions(const Json& json) {
    const Json& extensions = member(json, "extensions");
    for (const GltfMaterialExtension& extension : gltf_material_extensions()) {
        const Json& found = member(extensions, extension.name);
        if (found.is_null()) {
            continue;
        }
        const Material before = material;
        try {
            if (!found.is_object()) {
                throw PartError{"it is not an object"};
            }
            extension.read(found, *this);
        } catch (const PartError& fault) {
            material = before;
            warn(fmt::format("its {} is skipped: {}", extension.name, fault.reason));
        }
    }
}

void GltfMaterialReader::warn(std::string_view reason, std::string remedy) {
    import_.warn(fmt::format("material {}: {}", in_quotes(material.name), reason),
                 std::move(remedy));
}

GltfMaterials::GltfMaterials(const GltfDocument& document, Import& import)
    : root_(document.root()), import_(import), textures_(document, import) {}

const GltfMaterial& GltfMaterials::material(std::optional<std::size_t> gltf_material) {
    const auto known = materials_.find(gltf_material);
    if (known != materials_.end()) {
        return known->second;
    }
    GltfMaterial made;
    const Json nothing = Json::object();
    try {
        made = make(gltf_material ? element(root_, "materials", *gltf_material) : nothing);
    } catch (const PartError& fault) {
        import_.warn(fmt::format("material {} is replaced by glTF's default material: {}",
                                 *gltf_material, fault.reason));
        made = make(nothing);
    }
    return materials_.emplace(gltf_material, made).first->second;
}

GltfMaterial GltfMaterials::make(const Json& json) {
    GltfMaterialReader reader(textures_, import_);
    reader.read(json);
    GltfMaterial made;
    made.has_textures = !reader.coordinate_sets.empty();
    made.coordinate_sets = made.has_textures ? reader.coordinate_sets : std::vector<std::size_t>{0};
    made.has_normal_map =
        reader.material.normal_texture.valid() || reader.material.clearcoat_normal_texture.valid();
    import_.scene.materials.push_back(std::move(reader.material));
    made.index = MaterialIndex(import_.scene.materials.size() - 1);
    return made;
}

}  // namespace balcony::scene
