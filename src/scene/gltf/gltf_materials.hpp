// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/budget.hpp"
#include "scene/gltf/gltf_document.hpp"

namespace balcony::scene {

/// The channels of a texture's image.
struct Channel {
    static constexpr std::uint8_t red = 0, green = 1, blue = 2, alpha = 3;
};

/// The textures of a file, each made when a material first uses it.
class GltfTextures {
public:
    GltfTextures(const GltfDocument& document, Import& import);

    /// Textures with the same image and sampler are one. Invalid, after a warning, if its file is
    /// missing. Throws PartError if it cannot be used. `user` is for messages: "material 'm'".
    TextureIndex texture(std::size_t gltf_texture, const std::string& user);

private:
    void read_image(const Json& image, Texture& texture);

    struct Image {
        std::size_t image = 0;
        Wrap wrap_u = Wrap::repeat;
        Wrap wrap_v = Wrap::repeat;
        bool interpolated = true;
        auto operator<=>(const Image&) const = default;
    };

    const GltfDocument& document_;
    Import& import_;
    Budget image_bytes_;
    std::map<Image, TextureIndex> textures_;
};

/// A material, and what a mesh needs for it.
struct GltfMaterial {
    MaterialIndex index;
    /// The numbers of the TEXCOORD attributes that become the mesh's texture coordinates.
    std::vector<std::size_t> coordinate_sets;
    bool has_textures = false;
    bool has_normal_map = false;
};

/// Reads one material.
class GltfMaterialReader {
public:
    /// `user` is what messages call the material if it has no name.
    GltfMaterialReader(GltfTextures& textures, Import& import, std::string user)
        : textures_(textures), import_(import), user_(std::move(user)) {}

    /// Throws PartError if the core of the material is invalid; an extension or a texture that is
    /// invalid is skipped with a warning.
    void read(const Json& json);

    /// Reads a texture's use, such as the "normalTexture" of its owner. It remains without texture
    /// if there is none, or after a warning.
    void read_texture(const Json& owner, std::string_view key, TextureUse& use);
    /// The same of a texture of single numbers.
    void read_texture(const Json& owner, std::string_view key, std::uint8_t channel,
                      TextureUse& use);

    /// A number from 0 to 1. One that is beyond is limited, with a warning.
    [[nodiscard]] float unit_interval(const Json& owner, std::string_view key, float fallback);
    /// Warns of a property of the material.
    void warn(std::string_view reason, std::string remedy = {});

    Material material;
    std::vector<std::size_t> coordinate_sets;

private:
    void read_factors(const Json& json);
    void read_extensions(const Json& json);
    [[nodiscard]] std::uint8_t number_of_set(std::size_t gltf_set);

    GltfTextures& textures_;
    Import& import_;
    std::string user_;  // Such as "material 'm'".
};

/// An extension of materials that is read.
struct GltfMaterialExtension {
    std::string_view name;
    /// Adds to the reader's material. Throws PartError if a member is invalid.
    void (*read)(const Json& extension, GltfMaterialReader& reader);
};

[[nodiscard]] std::span<const GltfMaterialExtension> gltf_material_extensions();

/// The materials of a file, each made when a mesh first uses it.
class GltfMaterials {
public:
    GltfMaterials(const GltfDocument& document, Import& import);

    /// The material with an index, or glTF's default material.
    const GltfMaterial& material(std::optional<std::size_t> gltf_material);

private:
    [[nodiscard]] GltfMaterial make(const Json& json, const std::string& user);

    const Json& root_;
    Import& import_;
    GltfTextures textures_;
    std::map<std::optional<std::size_t>, GltfMaterial> materials_;
};

}  // namespace balcony::scene
