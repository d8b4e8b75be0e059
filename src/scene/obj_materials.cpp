// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/obj_materials.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "scene/obj_text.hpp"

namespace balcony::scene {

namespace {

void read_color(std::string_view arguments, Color3f& color) {
    Color3f read(0.0F);
    if (!to_float(take_word(arguments), read.x)) {
        return;
    }
    // One number stands for a grey.
    if (!to_float(take_word(arguments), read.y) || !to_float(take_word(arguments), read.z)) {
        read = Color3f(read.x);
    }
    color = {std::max(read.x, 0.0F), std::max(read.y, 0.0F), std::max(read.z, 0.0F)};
}

void read_unit_interval(std::string_view arguments, float& value) {
    float read = 0.0F;
    if (to_float(take_word(arguments), read)) {
        value = std::clamp(read, 0.0F, 1.0F);
    }
}

// A Phong exponent n has the spread of a microfacet surface with alpha = sqrt(2 / (n + 2)) (Walter
// and others 2007), and glTF's alpha is the square of its roughness.
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
    std::vector<std::string> read;
    for (const std::string& library : libraries) {
        if (std::find(read.begin(), read.end(), library) == read.end()) {
            read.push_back(library);
            read_library(beside(import.file, library));
        }
    }
}

void ObjMaterials::read_library(const std::filesystem::path& file) {
    std::vector<std::uint8_t> bytes;
    try {
        bytes = read_bytes(file);
    } catch (const ReadError& fault) {
        import_.warn(fmt::format("material library left out: {}", fault.diagnostic.message),
                     fault.diagnostic.remedy);
        return;
    }
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    std::string joined;
    const std::size_t first = sources_.size();
    while (!text.empty()) {
        const auto [keyword, arguments] = take_statement(text, joined);
        if (keyword == "newmtl") {
            sources_.emplace_back();
            sources_.back().material.name = arguments;
            sources_.back().library = file;
        } else if (sources_.size() > first) {
            read_line(sources_.back(), keyword, arguments);
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
    const auto found = std::find_if(sources_.rbegin(), sources_.rend(), [&](const Source& source) {
        return source.material.name == name;
    });
    Material material;
    material.name = name;
    if (found != sources_.rend()) {
        material = found->material;
        material.base_color_texture = add_texture(*found, found->color_map);
        material.emission_texture = add_texture(*found, found->emission_map);
        // An opacity map that is the colour's own image is its alpha channel.
        const bool same = parse_map(found->opacity_map).file == parse_map(found->color_map).file;
        const bool has_opacity_map = !found->opacity_map.empty();
        if (has_opacity_map && !same) {
            import_.warn(fmt::format("material {}: its opacity map is not read", in_quotes(name)));
        }
        const bool blends = material.alpha < 1.0F || (has_opacity_map && same);
        material.alpha_mode = blends ? AlphaMode::blend : AlphaMode::opaque;
    } else if (!name.empty()) {
        std::vector<std::string> names;
        for (const Source& source : sources_) {
            names.push_back(source.material.name);
        }
        const auto near = nearest_name(name, names);
        import_.warn(
            fmt::format("material {} is in no material library: it is grey", in_quotes(name)),
            near ? fmt::format("did you mean {}?", in_quotes(*near)) : "");
    }
    import_.scene.materials.push_back(std::move(material));
    return MaterialIndex(import_.scene.materials.size() - 1);
}

TextureIndex ObjMaterials::add_texture(const Source& source, const std::string& written) {
    const Map map = parse_map(written);
    if (map.file.empty()) {
        return {};
    }
    Texture texture;
    texture.name = map.file;
    texture.file = beside(source.library, map.file);
    texture.wrap_u = map.wrap;
    texture.wrap_v = map.wrap;
    std::error_code code;
    if (!std::filesystem::is_regular_file(texture.file, code)) {
        import_.warn(fmt::format("material {}: there is no texture file {}",
                                 in_quotes(source.material.name), in_quotes(texture.file.string())),
                     similar_file(texture.file));
        return {};
    }
    std::vector<Texture>& textures = import_.scene.textures;
    const auto known = std::find_if(textures.begin(), textures.end(), [&](const Texture& other) {
        return other.file == texture.file && other.wrap_u == texture.wrap_u;
    });
    const auto index = static_cast<std::size_t>(known - textures.begin());
    if (known == textures.end()) {
        textures.push_back(std::move(texture));
    }
    return TextureIndex(index);
}

}  // namespace balcony::scene
