// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/gltf/gltf_reader.hpp"

namespace balcony::scene {

namespace {

float unit_interval(const Json& json, const char* key, double fallback) {
    return static_cast<float>(std::clamp(number_in(json, key, fallback), 0.0, 1.0));
}

AlphaMode alpha_mode_of(const std::string& mode) {
    if (mode == "MASK") {
        return AlphaMode::mask;
    }
    return mode == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
}

Wrap wrap_of(std::size_t opengl_name) {
    switch (opengl_name) {
        case 33071: return Wrap::clamp;
        case 33648: return Wrap::mirror;
        default: return Wrap::repeat;
    }
}

// KHR_texture_transform: uv' = translation * rotation * scale * (u, v, 1), here for row vectors.
// The rotation is counter-clockwise on the image, where v points down, as in Khronos's viewer.
Imath::M33f transform_of(const Json& json) {
    const auto offset = numbers_in(json, "offset", {0.0, 0.0});
    const auto scale = numbers_in(json, "scale", {1.0, 1.0});
    const double angle = number_in(json, "rotation", 0.0);
    for (const double number : {offset[0], offset[1], scale[0], scale[1]}) {
        if (std::abs(number) > max_coordinate) {
            throw PartError{fmt::format("its transform is beyond {:g}", max_coordinate)};
        }
    }
    const auto c = static_cast<float>(std::cos(angle));
    const auto s = static_cast<float>(std::sin(angle));
    const auto x = static_cast<float>(scale[0]);
    const auto y = static_cast<float>(scale[1]);
    return {x * c,
            -x * s,
            0.0F,
            y * s,
            y * c,
            0.0F,
            static_cast<float>(offset[0]),
            static_cast<float>(offset[1]),
            1.0F};
}

Material read_factors(const Json& json) {
    Material made;
    made.name = text_in(json, "name");
    const Json& surface = member(json, "pbrMetallicRoughness");
    const auto base = numbers_in(surface, "baseColorFactor", {1.0, 1.0, 1.0, 1.0});
    made.base_color = to_color({base[0], base[1], base[2]}, "baseColorFactor");
    made.metallic = unit_interval(surface, "metallicFactor", 1.0);
    made.roughness = unit_interval(surface, "roughnessFactor", 1.0);
    made.alpha_mode = alpha_mode_of(text_in(json, "alphaMode", "OPAQUE"));
    if (made.alpha_mode != AlphaMode::opaque) {
        made.alpha = static_cast<float>(std::clamp(base[3], 0.0, 1.0));
    }
    if (made.alpha_mode == AlphaMode::mask) {
        made.alpha_cutoff = quantity_in(json, "alphaCutoff", 0.5F);
    }
    const Json& strength = member(member(json, "extensions"), "KHR_materials_emissive_strength");
    made.emission = scaled(color_in(json, "emissiveFactor", Color3f(0.0F)),
                           quantity_in(strength, "emissiveStrength", 1.0F), "emission");
    made.double_sided = flag_in(json, "doubleSided");
    return made;
}

}  // namespace

const GltfMaterial& GltfReader::material(std::optional<std::size_t> gltf_material) {
    const auto known = materials_.find(gltf_material);
    if (known != materials_.end()) {
        return known->second;
    }
    GltfMaterial made;
    const Json nothing = Json::object();
    try {
        made = read_material(gltf_material ? element(root_, "materials", *gltf_material) : nothing);
    } catch (const PartError& fault) {
        import_.warn(fmt::format("material {} is replaced by glTF's default material: {}",
                                 *gltf_material, fault.reason));
        made = read_material(nothing);
    }
    return materials_.emplace(gltf_material, made).first->second;
}

GltfMaterial GltfReader::read_material(const Json& json) {
    Material read = read_factors(json);
    const Json& surface = member(json, "pbrMetallicRoughness");
    const TextureUse base = texture_use(surface, "baseColorTexture", read.name);
    const TextureUse shine = texture_use(surface, "metallicRoughnessTexture", read.name);
    const TextureUse glow = texture_use(json, "emissiveTexture", read.name);
    read.base_color_texture = base.index;
    read.metallic_roughness_texture = shine.index;
    read.emission_texture = glow.index;
    if (member(json, "normalTexture").is_object()) {
        import_.warn(
            fmt::format("material {}: normal maps are not supported", in_quotes(read.name)));
    }
    GltfMaterial made;
    choose_texture_coordinates({base, shine, glow}, made);
    scene_.materials.push_back(std::move(read));
    made.index = MaterialIndex(scene_.materials.size() - 1);
    return made;
}

// The first texture determines the coordinates; other textures use the same ones.
void GltfReader::choose_texture_coordinates(const std::vector<TextureUse>& uses,
                                            GltfMaterial& made) {
    const auto first = std::find_if(uses.begin(), uses.end(),
                                    [](const TextureUse& use) { return use.index.valid(); });
    if (first == uses.end()) {
        return;
    }
    made.texture_coordinate_set = first->set;
    made.texture_transform = first->transform;
    for (const TextureUse& use : uses) {
        if (use.index.valid() && (use.set != first->set || use.transform != first->transform)) {
            import_.warn(fmt::format(
                "texture {} uses the coordinates of texture {}: a material has only one set",
                in_quotes(scene_.textures[use.index.value()].name),
                in_quotes(scene_.textures[first->index.value()].name)));
        }
    }
}

GltfReader::TextureUse GltfReader::texture_use(const Json& owner, const char* key,
                                               const std::string& material_name) {
    TextureUse use;
    const Json& json = member(owner, key);
    if (!json.is_object()) {
        return use;
    }
    try {
        const Json& transform = member(member(json, "extensions"), "KHR_texture_transform");
        use.set = count_in(transform, "texCoord", count_in(json, "texCoord", 0));
        use.transform = transform_of(transform);
        const std::size_t number = count_in(json, "index", SIZE_MAX);
        use.index = texture(element(root_, "textures", number), material_name);
    } catch (const PartError& fault) {
        import_.warn(fmt::format("material {}: its '{}' is skipped: {}", in_quotes(material_name),
                                 key, fault.reason));
    }
    return use;
}

// Textures with the same image and sampler are merged.
TextureIndex GltfReader::texture(const Json& json, const std::string& material_name) {
    const auto source = index_in(json, "source");
    if (!source) {
        throw PartError{"its image format is not supported"};
    }
    Texture texture;
    if (const auto sampler = index_in(json, "sampler")) {
        const Json& wraps = element(root_, "samplers", *sampler);
        texture.wrap_u = wrap_of(count_in(wraps, "wrapS", 0));
        texture.wrap_v = wrap_of(count_in(wraps, "wrapT", 0));
    }
    const auto [known, is_new] = textures_.try_emplace({*source, texture.wrap_u, texture.wrap_v});
    if (!is_new) {
        return known->second;
    }
    const Json& image = element(root_, "images", *source);
    texture.name = text_in(image, "name", fmt::format("image {}", *source));
    read_image(image, texture);
    std::error_code code;
    if (texture.bytes.empty() && !std::filesystem::is_regular_file(texture.file, code)) {
        import_.warn(fmt::format("material {}: there is no texture file {}",
                                 in_quotes(material_name), in_quotes(texture.file.string())),
                     import_.advice_on(texture.file));
        return {};
    }
    scene_.textures.push_back(std::move(texture));
    known->second = TextureIndex(scene_.textures.size() - 1);
    return known->second;
}

void GltfReader::read_image(const Json& image, Texture& texture) {
    const std::string uri = text_in(image, "uri");
    if (const auto view = index_in(image, "bufferView")) {
        const auto bytes = document_.view(*view);
        image_bytes_.take(bytes.size());
        texture.bytes.assign(bytes.begin(), bytes.end());
    } else if (uri.starts_with("data:")) {
        image_bytes_.take(uri.size());
        texture.bytes = decode_data_uri(uri);
    } else if (!uri.empty()) {
        texture.file = import_.beside(import_.file, decode_percent(uri));
        return;
    }
    if (texture.bytes.empty()) {
        throw PartError{"its image is empty"};
    }
}

}  // namespace balcony::scene
