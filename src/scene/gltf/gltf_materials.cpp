// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/gltf/gltf_materials.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace balcony::scene {

namespace {

std::optional<AlphaMode> alpha_mode_of(std::string_view mode) {
    return mode == "OPAQUE"  ? std::optional(AlphaMode::opaque)
           : mode == "MASK"  ? std::optional(AlphaMode::mask)
           : mode == "BLEND" ? std::optional(AlphaMode::blend)
                             : std::nullopt;
}

}  // namespace

float GltfMaterialReader::unit_interval(const Json& owner, std::string_view key, float fallback) {
    constexpr double rounding = 1e-4;  // Some exporters write 1.00001.
    const double number = number_in(owner, key, double{fallback});
    const double limited = std::clamp(number, 0.0, 1.0);
    if (std::abs(number - limited) > rounding) {
        warn(fmt::format("its '{}' is {:g} and counts as {:g}", key, number, limited),
             "give it a value from 0 to 1");
    }
    return static_cast<float>(limited);
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
    if (!material.name.empty()) {
        user_ = fmt::format("material {}", in_quotes(material.name));
    }
    const Json& surface = member(json, "pbrMetallicRoughness");
    const auto base = numbers_in(surface, "baseColorFactor", {1.0, 1.0, 1.0, 1.0});
    material.base_color = to_color({base[0], base[1], base[2]}, "baseColorFactor");
    material.metallic = unit_interval(surface, "metallicFactor", 1.0F);
    material.roughness = unit_interval(surface, "roughnessFactor", 1.0F);
    const std::string mode = text_in(json, "alphaMode", "OPAQUE");
    const std::optional<AlphaMode> known_mode = alpha_mode_of(mode);
    material.alpha_mode = known_mode.value_or(AlphaMode::opaque);
    if (!known_mode) {
        warn(fmt::format("its 'alphaMode' is {} and counts as 'OPAQUE'", in_quotes(mode)),
             "the modes are OPAQUE, MASK and BLEND");
    }
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
    import_.warn(fmt::format("{}: {}", user_, reason), std::move(remedy));
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
    const std::string user =
        gltf_material ? fmt::format("material {}", *gltf_material) : "the default material";
    try {
        made = make(gltf_material ? element(root_, "materials", *gltf_material) : nothing, user);
    } catch (const PartError& fault) {
        import_.warn(
            fmt::format("{} is replaced by glTF's default material: {}", user, fault.reason));
        made = make(nothing, user);
    }
    return materials_.emplace(gltf_material, made).first->second;
}

GltfMaterial GltfMaterials::make(const Json& json, const std::string& user) {
    GltfMaterialReader reader(textures_, import_, user);
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
