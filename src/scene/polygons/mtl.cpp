// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/polygons/mtl.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "scene/polygons/words.hpp"

namespace balcony::scene {

namespace {

std::optional<Color3f> read_color(std::string_view arguments) {
    Color3f read(0.0F);
    if (!to_float(take_word(arguments), read.x)) {
        return std::nullopt;
    }
    // A single number is a grey.
    if (!to_float(take_word(arguments), read.y) || !to_float(take_word(arguments), read.z)) {
        read = Color3f(read.x);
    }
    const auto fits = [](float part) { return part >= 0.0F && double{part} <= max_quantity; };
    return fits(read.x) && fits(read.y) && fits(read.z) ? std::optional(read) : std::nullopt;
}

bool assign(std::string_view arguments, std::optional<Color3f>& color) {
    const auto read = read_color(arguments);
    color = read ? read : color;
    return read.has_value();
}

std::optional<float> read_number(std::string_view arguments) {
    float number = 0.0F;
    return to_float(take_word(arguments), number) ? std::optional(number) : std::nullopt;
}

// Calls an action with the number that a statement has.
template <class Action>
bool with_number(std::string_view arguments, Action action) {
    const auto number = read_number(arguments);
    if (number) {
        action(*number);
    }
    return number.has_value();
}

float unit(float number) { return std::clamp(number, 0.0F, 1.0F); }

// A Phong exponent n has the highlight width of a microfacet surface with alpha = sqrt(2 / (n + 2))
// (Walter and others 2007), and glTF's alpha is the square of its roughness.
float roughness_of_exponent(float exponent) {
    return std::pow(2.0F / (std::max(exponent, 0.0F) + 2.0F), 0.25F);
}

struct Row {
    std::string_view keyword;
    bool (*read)(std::string_view arguments, MtlMaterial& to);
};

constexpr std::array rows{
    Row{"Kd", [](std::string_view a, MtlMaterial& to) { return assign(a, to.diffuse); }},
    Row{"Ks", [](std::string_view a, MtlMaterial& to) { return assign(a, to.specular); }},
    Row{"Ke", [](std::string_view a, MtlMaterial& to) { return assign(a, to.emission); }},
    Row{"Tf",
        [](std::string_view a, MtlMaterial& to) {
            const auto read = read_color(a);
            to.filter = read.value_or(to.filter);
            return read.has_value();
        }},
    Row{"d",
        [](std::string_view a, MtlMaterial& to) {
            return with_number(a, [&](float number) { to.opacity = unit(number); });
        }},
    Row{"Tr",
        [](std::string_view a, MtlMaterial& to) {
            return with_number(a, [&](float number) { to.opacity = 1.0F - unit(number); });
        }},
    Row{"Ni",
        [](std::string_view a, MtlMaterial& to) {
            return with_number(a, [&](float number) { to.refraction_index = number; });
        }},
    Row{"illum",
        [](std::string_view a, MtlMaterial& to) {
            return with_number(a, [&](float number) {
                to.illumination = static_cast<int>(std::clamp(number, 0.0F, 10.0F));
            });
        }},
    Row{"Ns",
        [](std::string_view a, MtlMaterial& to) {
            return with_number(a, [&](float number) {
                to.exponent = number;
                to.roughness.reset();
            });
        }},
    Row{"Pr",
        [](std::string_view a, MtlMaterial& to) {
            return with_number(a, [&](float number) {
                to.roughness = unit(number);
                to.exponent.reset();
            });
        }},
    Row{"Pm",
        [](std::string_view a, MtlMaterial& to) {
            return with_number(a, [&](float number) { to.metallic = unit(number); });
        }},
    Row{"Pc",
        [](std::string_view a, MtlMaterial& to) {
            return with_number(a, [&](float number) { to.clearcoat = unit(number); });
        }},
    Row{"Pcr",
        [](std::string_view a, MtlMaterial& to) {
            return with_number(a, [&](float number) { to.clearcoat_roughness = unit(number); });
        }},
    Row{"Ps", [](std::string_view a, MtlMaterial& to) {
            return with_number(a, [&](float number) { to.sheen = unit(number); });
        }}};

constexpr std::array known_maps{MtlMap{"map_Kd", &Material::base_color_texture},
                                MtlMap{"map_Ke", &Material::emission_texture},
                                MtlMap{"map_d", &Material::opacity_texture},
                                MtlMap{"map_Pr", &Material::roughness_texture},
                                MtlMap{"map_Pm", &Material::metallic_texture},
                                MtlMap{"map_Pc", &Material::clearcoat_texture},
                                MtlMap{"map_Pcr", &Material::clearcoat_roughness_texture},
                                MtlMap{"map_Ps", &Material::sheen_color_texture},
                                MtlMap{"norm", &Material::normal_texture}};

// Models 3 to 7 trace reflections, which are sharp unless the highlight says otherwise. The format
// has no exponent above 1000.
float roughness_of(const MtlMaterial& mtl) {
    constexpr float sharpest = 1000.0F;
    const bool traces = mtl.illumination >= 3 && mtl.illumination <= 7;
    if (mtl.roughness) {
        return *mtl.roughness;
    }
    if (traces && mtl.exponent.value_or(sharpest) >= sharpest) {
        return 0.0F;
    }
    return mtl.exponent ? roughness_of_exponent(*mtl.exponent) : 1.0F;
}

// Models 0 and 1 have no highlight. Models 3, 5 and 8 are mirrors, whose reflectance is Ks; other
// models leave Ks to the index of refraction, because most programs write it without meaning.
void set_reflection(const MtlMaterial& mtl, Material& material) {
    const int model = mtl.illumination;
    if (model == 0 || model == 1) {
        material.specular = 0.0F;
    } else if ((model == 3 || model == 5 || model == 8) && mtl.specular) {
        const float normal_reflectance =
            std::pow((material.ior - 1.0F) / (material.ior + 1.0F), 2.0F);
        material.specular_color = *mtl.specular / normal_reflectance;
    }
}

// Model 4 is glass without refraction, 6 and 7 are glass with it. Their d, if any, is not a
// cut-out but says how much of the light passes.
void set_transmission(const MtlMaterial& mtl, Material& material) {
    const int model = mtl.illumination;
    if (model != 4 && model != 6 && model != 7) {
        return;
    }
    material.transmission = mtl.opacity < 1.0F ? 1.0F - mtl.opacity : 1.0F;
    material.alpha = 1.0F;
    material.base_color += material.transmission * (mtl.filter - material.base_color);
    material.thin_walled = model == 4;
}

}  // namespace

bool read_statement(std::string_view keyword, std::string_view arguments, MtlMaterial& material) {
    const auto* row = std::find_if(rows.begin(), rows.end(),
                                   [&](const Row& known) { return known.keyword == keyword; });
    if (row != rows.end()) {
        return row->read(arguments, material);
    }
    if (keyword.starts_with("map_") || keyword == "norm" || keyword == "bump" ||
        keyword == "disp" || keyword == "decal") {
        material.maps.insert_or_assign(std::string(keyword), std::string(arguments));
    }
    return true;
}

Material to_material(const MtlMaterial& mtl) {
    const auto if_mapped = [&](std::string_view keyword, float mapped, float otherwise) {
        return mtl.maps.contains(keyword) ? mapped : otherwise;
    };
    Material material;
    material.name = mtl.name;
    material.base_color =
        mtl.diffuse.value_or(Color3f(if_mapped("map_Kd", 1.0F, material.base_color.x)));
    material.emission = mtl.emission.value_or(Color3f(if_mapped("map_Ke", 1.0F, 0.0F)));
    material.alpha = mtl.opacity;
    material.metallic = mtl.metallic.value_or(if_mapped("map_Pm", 1.0F, 0.0F));
    material.roughness = mtl.roughness.value_or(if_mapped("map_Pr", 1.0F, roughness_of(mtl)));
    // Many programs write an index of 1 for anything.
    if (mtl.refraction_index > 1.0F) {
        material.ior =
            static_cast<float>(std::min(double{mtl.refraction_index}, max_refraction_index));
    }
    material.clearcoat = mtl.clearcoat;
    material.clearcoat_roughness = mtl.clearcoat_roughness;
    material.sheen_color = Color3f(mtl.sheen);
    constexpr float usual_sheen_roughness = 0.5F;
    material.sheen_roughness = usual_sheen_roughness;
    set_reflection(mtl, material);
    set_transmission(mtl, material);
    return material;
}

std::span<const MtlMap> mtl_maps() { return known_maps; }

namespace {

// "-o 0.5 0 wood.png": one to three numbers, of which the third is depth.
V2f take_numbers(std::string_view& arguments, V2f vector) {
    float number = 0.0F;
    int count = 0;
    for (std::string_view rest = arguments; to_float(take_word(rest), number) && !rest.empty();) {
        if (count < 2) {
            vector[count++] = number;
        }
        arguments = rest;
    }
    return vector;
}

void read_option(std::string_view option, std::string_view value, MtlMapArguments& map) {
    constexpr std::string_view channels = "rgbm";
    if (option == "-clamp" && value == "on") {
        map.wrap = Wrap::clamp;
    } else if (option == "-bm") {
        (void)to_float(value, map.multiplier);
    } else if (option == "-imfchan" && value.size() == 1 &&
               channels.find(value) != std::string_view::npos) {
        map.channel = static_cast<std::uint8_t>(channels.find(value));
    }
}

}  // namespace

MtlMapArguments parse_map(std::string_view arguments) {
    static const std::map<std::string_view, int> options{
        {"-blendu", 1}, {"-blendv", 1}, {"-boost", 1},   {"-mm", 2},   {"-texres", 1},
        {"-clamp", 1},  {"-bm", 1},     {"-imfchan", 1}, {"-type", 1}, {"-cc", 1}};
    MtlMapArguments map;
    for (;;) {
        std::string_view rest = arguments;
        const std::string_view word = take_word(rest);
        if (word == "-o") {
            map.offset = take_numbers(rest, V2f(0.0F, 0.0F));
        } else if (word == "-s") {
            map.scale = take_numbers(rest, V2f(1.0F, 1.0F));
        } else if (word == "-t") {
            (void)take_numbers(rest, V2f(0.0F, 0.0F));
        } else if (const auto option = options.find(word); option != options.end()) {
            for (int i = 0; i < option->second; ++i) {
                read_option(word, take_word(rest), map);
            }
        } else {
            map.file = word.empty() ? std::string_view() : arguments.substr(arguments.find(word));
            return map;
        }
        arguments = rest;
    }
}

}  // namespace balcony::scene
