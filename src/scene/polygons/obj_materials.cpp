// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/polygons/obj_materials.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "scene/polygons/words.hpp"

namespace balcony::scene {

namespace {

void read_color(std::string_view arguments, Color3f& color) {
    Color3f read(0.0F);
    if (!to_float(take_word(arguments), read.x)) {
        return;
    }
    // A single number is a grey.
    if (!to_float(take_word(arguments), read.y) || !to_float(take_word(arguments), read.z)) {
        read = Color3f(read.x);
    }
    constexpr auto maximum = static_cast<float>(max_quantity);
    color = {std::clamp(read.x, 0.0F, maximum), std::clamp(read.y, 0.0F, maximum),
             std::clamp(read.z, 0.0F, maximum)};
}

void read_unit_interval(std::string_view arguments, float& value) {
    float read = 0.0F;
    if (to_float(take_word(arguments), read)) {
        value = std::clamp(read, 0.0F, 1.0F);
    }
}

// A Phong exponent n has the highlight width of a microfacet surface with alpha = sqrt(2 / (n + 2))
// (Walter and others 2007), and glTF's alpha is the square of its roughness.
float roughness_of_exponent(float exponent) {
    return std::pow(2.0F / (std::max(exponent, 0.0F) + 2.0F), 0.25F);
}

struct Map {
    std::string_view file;
    Wrap wrap = Wrap::repeat;
};

// "-clamp on -s 1 1 1 wood grain.png": options with their arguments, then a name to the line's end.
Map parse_map(std::string_view arguments) {
    static const std::map<std::string_view, int> options{
        {"-blendu", 1}, {"-blendv", 1}, {"-boost", 1},   {"-mm", 2},   {"-texres", 1},
        {"-clamp", 1},  {"-bm", 1},     {"-imfchan", 1}, {"-type", 1}, {"-cc", 1}};
    Map map;
    for (;;) {
        std::string_view rest = arguments;
        const std::string_view word = take_word(rest);
        if (word == "-o" || word == "-s" || word == "-t") {
            // One to three numbers.
            float number = 0.0F;
            for (std::string_view ahead = rest;
                 to_float(take_word(ahead), number) && !ahead.empty();) {
                rest = ahead;
            }
        } else if (const auto option = options.find(word); option != options.end()) {
            for (int i = 0; i < option->second; ++i) {
                const std::string_view value = take_word(rest);
                map.wrap = word == "-clamp" && value == "on" ? Wrap::clamp : map.wrap;
            }
        } else {
            arguments.remove_prefix(static_cast<std::size_t>(
                word.empty() ? static_cast<std::ptrdiff_t>(arguments.size())
                             : word.data() - arguments.data()));
            map.file = arguments;
            return map;
        }
        arguments = rest;
    }
}

}  // namespace

ObjMaterials::ObjMaterials(const std::vector<std::string>& libraries, Import& import)
    : import_(import) {
    std::set<std::filesystem::path> read;
    for (const std::string& library : libraries) {
        const std::filesystem::path file = import.beside(import.file, library);
        if (read.insert(file).second) {
            read_library(file);
        }
    }
}

void ObjMaterials::read_library(const std::filesystem::path& file) {
    if (!import_.adds_warnings() && !std::filesystem::exists(file)) {
        import_.warn("");
        return;
    }
    std::vector<std::uint8_t> bytes;
    try {
        bytes = read_bytes(file);
    } catch (const ReadError& fault) {
        import_.warn(fmt::format("material library skipped: {}", fault.diagnostic.message),
                     fault.diagnostic.remedy);
        return;
    }
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    std::string joined;
    Source* source = nullptr;
    while (!text.empty()) {
        const auto [keyword, arguments] = take_statement(text, joined);
        if (keyword == "newmtl") {
            source = &sources_.insert_or_assign(std::string(arguments), Source()).first->second;
            source->material.name = arguments;
            source->library = file;
        } else if (source != nullptr) {
            read_line(*source, keyword, arguments);
        }
    }
}

void ObjMaterials::read_line(Source& source, std::string_view keyword, std::string_view arguments) {
    Material& material = source.material;
    float number = 0.0F;
    if (keyword == "Kd") {
        read_color(arguments, material.base_color);
    } else if (keyword == "Ke") {
        read_color(arguments, material.emission);
    } else if (keyword == "d") {
        read_unit_interval(arguments, material.alpha);
    } else if (keyword == "Tr" && to_float(take_word(arguments), number)) {
        material.alpha = std::clamp(1.0F - number, 0.0F, 1.0F);
    } else if (keyword == "Pr") {
        read_unit_interval(arguments, material.roughness);
    } else if (keyword == "Pm") {
        read_unit_interval(arguments, material.metallic);
    } else if (keyword == "Ns" && to_float(take_word(arguments), number)) {
        material.roughness = roughness_of_exponent(number);
    } else if (keyword == "map_Kd") {
        source.color_map = arguments;
    } else if (keyword == "map_Ke") {
        source.emission_map = arguments;
    } else if (keyword == "map_d") {
        source.opacity_map = arguments;
    }
}

MaterialIndex ObjMaterials::add_to_scene(const std::string& name) {
    const auto found = sources_.find(name);
    Material material;
    material.name = name;
    if (found != sources_.end()) {
        const Source& source = found->second;
        material = source.material;
        material.base_color_texture.index = add_texture(source, source.color_map);
        material.emission_texture.index = add_texture(source, source.emission_map);
        // If the opacity map is the colour's own image, its alpha channel is the opacity.
        const bool same = parse_map(source.opacity_map).file == parse_map(source.color_map).file;
        const bool has_opacity_map = !source.opacity_map.empty();
        if (has_opacity_map && !same) {
            import_.warn(fmt::format("material {}: separate opacity maps are not supported",
                                     in_quotes(name)));
        }
        if (has_opacity_map && same) {
            material.opacity_texture = material.base_color_texture;
            material.opacity_texture.channel = 3;
        }
        const bool blends = material.alpha < 1.0F || (has_opacity_map && same);
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

TextureIndex ObjMaterials::add_texture(const Source& source, const std::string& written) {
    const Map map = parse_map(written);
    if (map.file.empty()) {
        return {};
    }
    const std::filesystem::path file = import_.beside(source.library, map.file);
    const auto [known, is_new] = textures_.try_emplace({file, map.wrap});
    if (!is_new && known->second.valid()) {
        return known->second;
    }
    std::error_code code;
    if (!std::filesystem::is_regular_file(file, code)) {
        import_.warn(fmt::format("material {}: there is no texture file {}",
                                 in_quotes(source.material.name), in_quotes(file.string())),
                     import_.advice_on(file));
        return {};
    }
    std::vector<Texture>& textures = import_.scene.textures;
    textures.push_back({std::string(map.file), file, {}, map.wrap, map.wrap});
    known->second = TextureIndex(textures.size() - 1);
    return known->second;
}

}  // namespace balcony::scene
