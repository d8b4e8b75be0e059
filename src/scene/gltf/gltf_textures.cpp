// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "scene/gltf/gltf_materials.hpp"

namespace balcony::scene {

namespace {

Wrap wrap_of(std::size_t opengl_name) {
    switch (opengl_name) {
        case 33071: return Wrap::clamp;
        case 33648: return Wrap::mirror;
        default: return Wrap::repeat;
    }
}

constexpr std::size_t opengl_nearest = 9728;

// The image of a texture; an extension may name one in a format that not all programs read.
std::optional<std::size_t> image_of(const Json& texture) {
    const Json& webp = member(member(texture, "extensions"), "EXT_texture_webp");
    const auto source = index_in(webp, "source");
    return source ? source : index_in(texture, "source");
}

// KHR_texture_transform: translation * rotation * scale * (u, v, 1). The rotation is
// counter-clockwise on the image, where v points down, as in Khronos's viewer.
void read_transform(const Json& json, TextureUse& use) {
    const auto offset = numbers_in(json, "offset", {0.0, 0.0});
    const auto scale = numbers_in(json, "scale", {1.0, 1.0});
    const double angle = number_in(json, "rotation", 0.0);
    for (const double number : {offset[0], offset[1], scale[0], scale[1]}) {
        if (std::abs(number) > max_coordinate) {
            throw PartError{fmt::format("its transform is beyond {:g}", max_coordinate)};
        }
    }
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    use.offset = V2f(Imath::V2d(offset[0], offset[1]));
    use.u_axis = V2f(scale[0] * Imath::V2d(c, -s));
    use.v_axis = V2f(scale[1] * Imath::V2d(s, c));
}

}  // namespace

// An image may have two textures of its own, and is copied for each.
GltfTextures::GltfTextures(const GltfDocument& document, Import& import)
    : document_(document),
      import_(import),
      image_bytes_(2 * document.size(),
                   "the file's images have more bytes than a file of its size may have") {}

TextureIndex GltfTextures::texture(std::size_t gltf_texture, const std::string& user) {
    const Json& root = document_.root();
    const Json& json = element(root, "textures", gltf_texture);
    const auto source = image_of(json);
    if (!source) {
        throw PartError{"its image format is not supported"};
    }
    Texture texture;
    if (const auto sampler = index_in(json, "sampler")) {
        const Json& properties = element(root, "samplers", *sampler);
        texture.wrap_u = wrap_of(count_in(properties, "wrapS", 0));
        texture.wrap_v = wrap_of(count_in(properties, "wrapT", 0));
        texture.interpolated = count_in(properties, "magFilter", 0) != opengl_nearest;
    }
    const auto [known, is_new] =
        textures_.try_emplace({*source, texture.wrap_u, texture.wrap_v, texture.interpolated});
    if (!is_new) {
        return known->second;
    }
    const Json& image = element(root, "images", *source);
    read_image(image, texture);
    if (texture.bytes->empty() && !import_.has_texture(texture.file, user)) {
        return {};
    }
    texture.name = text_in(image, "name",
                           texture.bytes->empty() ? texture.file.filename().string()
                                                  : fmt::format("image {}", *source));
    import_.scene.textures.push_back(std::move(texture));
    known->second = TextureIndex(import_.scene.textures.size() - 1);
    return known->second;
}

void GltfTextures::read_image(const Json& image, Texture& texture) {
    const std::string_view uri = document_.uri_in(image);
    if (const auto view = index_in(image, "bufferView")) {
        const auto bytes = document_.view(*view);
        image_bytes_.take(bytes.size());
        texture.bytes = std::vector(bytes.begin(), bytes.end());
    } else if (uri.starts_with("data:")) {
        image_bytes_.take(uri.size());
        texture.bytes = decode_data_uri(uri);
    } else if (!uri.empty()) {
        texture.file = import_.beside(import_.file, decode_percent(uri));
        return;
    }
    if (texture.bytes->empty()) {
        throw PartError{"its image is empty"};
    }
}

void GltfMaterialReader::read_texture(const Json& owner, std::string_view key, TextureUse& use) {
    const Json& json = member(owner, key);
    if (json.is_null()) {
        return;
    }
    try {
        if (!json.is_object()) {
            throw PartError{"it is not an object"};
        }
        TextureUse read = use;
        const Json& transform = member(member(json, "extensions"), "KHR_texture_transform");
        read_transform(transform, read);
        const auto number = index_in(json, "index");
        if (!number) {
            throw PartError{"it has no 'index'"};
        }
        read.index = textures_.texture(*number, user_);
        if (read.valid()) {
            read.coordinates =
                number_of_set(count_in(transform, "texCoord", count_in(json, "texCoord", 0)));
        }
        use = read;
    } catch (const PartError& fault) {
        warn(fmt::format("its '{}' is skipped: {}", key, fault.reason), fault.remedy);
    }
}

void GltfMaterialReader::read_texture(const Json& owner, std::string_view key, std::uint8_t channel,
                                      TextureUse& use) {
    read_texture(owner, key, use);
    use.channel = channel;
}

std::uint8_t GltfMaterialReader::number_of_set(std::size_t gltf_set) {
    const auto known = std::find(coordinate_sets.begin(), coordinate_sets.end(), gltf_set);
    const auto number = static_cast<std::size_t>(known - coordinate_sets.begin());
    if (known == coordinate_sets.end()) {
        if (coordinate_sets.size() == max_coordinate_sets) {
            throw PartError{fmt::format("it uses TEXCOORD_{}, and a material has at most {} sets",
                                        gltf_set, max_coordinate_sets)};
        }
        coordinate_sets.push_back(gltf_set);
    }
    return static_cast<std::uint8_t>(number);
}

}  // namespace balcony::scene
