// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/polygons/obj_materials.hpp"

#include <array>
#include <map>
#include <set>

#include <fmt/format.h>

#include "scene/polygons/words.hpp"

namespace balcony::scene {

namespace {

// Maps that pictures would need, and what to do instead.
struct UnreadMap {
    std::string_view keyword;
    std::string_view remedy;
};

constexpr std::array unread_maps{
    UnreadMap{"map_Bump", "heights are not supported; a normal map is stated by 'norm'"},
    UnreadMap{"map_bump", "heights are not supported; a normal map is stated by 'norm'"},
    UnreadMap{"bump", "heights are not supported; a normal map is stated by 'norm'"},
    UnreadMap{"disp", "apply the displacement to the mesh before exporting it"},
    UnreadMap{"decal", "paint it into the image of 'map_Kd'"},
    UnreadMap{"map_Ns", "a map of the roughness is stated by 'map_Pr'"},
    UnreadMap{"map_Ks", ""}};

// A place (u, v) counts v from the bottom of the image, a TextureUse from its top.
void set_transform(const MtlMapArguments& map, TextureUse& use) {
    use.u_axis = V2f(map.scale.x, 0.0F);
    use.v_axis = V2f(0.0F, map.scale.y);
    use.offset = V2f(map.offset.x, 1.0F - map.scale.y - map.offset.y);
}

}  // namespace

ObjMaterials::ObjMaterials(const std::vector<std::string>& libraries, Import& import)
    : import_(import) {
    std::set<std::filesystem::path> read;
    for (const std::string& library : libraries) {
        try {
            const std::filesystem::path file = import.beside(import.file, library);
            if (read.insert(file).second) {
                read_library(file);
            }
        } catch (const PartError& fault) {
            import.warn(fmt::format("material library skipped: {}", fault.reason), fault.remedy);
        }
    }
}

void ObjMaterials::read_library(const std::filesystem::path& file) {
    if (!import_.adds_warnings() && !std::filesystem::exists(file)) {
        import_.warn("");
        return;
    }
    std::vector<std::uint8_t> bytes;
    std::string_view text;
    try {
        bytes = import_.bytes_of(file);
        text = text_of(bytes, file);
    } catch (const ReadError& fault) {
        import_.warn(fmt::format("material library skipped: {}", fault.diagnostic.message),
                     fault.diagnostic.remedy);
        return;
    }
    std::string joined;
    Source* source = nullptr;
    while (!text.empty()) {
        const auto [keyword, arguments] = take_statement(text, joined);
        if (keyword == "newmtl") {
            source = &sources_.insert_or_assign(std::string(arguments), Source()).first->second;
            source->material.name = arguments;
            source->library = file;
        } else if (source != nullptr && !read_statement(keyword, arguments, source->material)) {
            import_.warn(
                fmt::format("material {}: '{}' is ignored: its numbers are missing or out of range",
                            in_quotes(source->material.name), keyword));
        }
    }
}

MaterialIndex ObjMaterials::add_to_scene(const std::string& name) {
    const auto found = sources_.find(name);
    Material material;
    material.name = name;
    if (found != sources_.end()) {
        const Source& source = found->second;
        material = to_material(source.material);
        add_maps(source, material);
        const bool blends = material.alpha < 1.0F || material.opacity_texture.valid();
        material.alpha_mode = blends ? AlphaMode::blend : AlphaMode::opaque;
    } else if (!name.empty()) {
        const auto near = nearest_source(name);
        import_.warn(fmt::format("material {} is in no material library; grey is used instead",
                                 in_quotes(name)),
                     near ? fmt::format("did you mean {}?", in_quotes(*near)) : "");
    }
    import_.scene.materials.push_back(std::move(material));
    return MaterialIndex(import_.scene.materials.size() - 1);
}

std::optional<std::string> ObjMaterials::nearest_source(const std::string& name) const {
    if (!import_.adds_warnings()) {
        return std::nullopt;
    }
    std::vector<std::string> names;
    for (const auto& [known, source] : sources_) {
        names.push_back(known);
    }
    return nearest_name(name, names);
}

void ObjMaterials::add_maps(const Source& source, Material& material) {
    const auto& maps = source.material.maps;
    for (const MtlMap& known : mtl_maps()) {
        const auto written = maps.find(known.keyword);
        if (written == maps.end()) {
            continue;
        }
        const MtlMapArguments map = parse_map(written->second);
        TextureUse& use = material.*known.use;
        use.index = add_texture(source, map);
        use.channel = map.channel.value_or(use.channel);
        set_transform(map, use);
        if (known.keyword == "norm") {
            material.normal_scale = map.multiplier;
        }
    }
    // If the opacity map is the colour's own image, its alpha channel is the opacity.
    if (material.opacity_texture.valid() &&
        material.opacity_texture.index == material.base_color_texture.index) {
        constexpr std::uint8_t alpha = 3;
        material.opacity_texture = material.base_color_texture;
        material.opacity_texture.channel = alpha;
    }
    for (const UnreadMap& unread : unread_maps) {
        if (maps.contains(unread.keyword)) {
            import_.warn(fmt::format("material {}: '{}' is not supported", in_quotes(material.name),
                                     unread.keyword),
                         std::string(unread.remedy));
        }
    }
}

TextureIndex ObjMaterials::add_texture(const Source& source, const MtlMapArguments& map) {
    if (map.file.empty()) {
        return {};
    }
    std::filesystem::path file;
    try {
        file = import_.beside(source.library, map.file);
    } catch (const PartError& fault) {
        import_.warn(fmt::format("material {}: its texture is skipped: {}",
                                 in_quotes(source.material.name), fault.reason),
                     fault.remedy);
        return {};
    }
    const auto [known, is_new] = textures_.try_emplace({file, map.wrap});
    if (!is_new && known->second.valid()) {
        return known->second;
    }
    if (!import_.has_texture(file, fmt::format("material {}", in_quotes(source.material.name)))) {
        return {};
    }
    std::vector<Texture>& textures = import_.scene.textures;
    textures.push_back({std::string(map.file), file, {}, map.wrap, map.wrap});
    known->second = TextureIndex(textures.size() - 1);
    return known->second;
}

}  // namespace balcony::scene
