// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The statements of a Wavefront material library, with the PBR extension of Stockner ("Pr", "Pm",
// "Pc", "Ps", "norm").

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "balcony/scene.hpp"

namespace balcony::scene {

/// A material as a library states it; what it does not state is empty.
struct MtlMaterial {
    std::string name;
    std::optional<Color3f> diffuse;
    std::optional<Color3f> specular;
    std::optional<Color3f> emission;
    Color3f filter{1.0F, 1.0F, 1.0F};  ///< Of transmitted light.
    float opacity = 1.0F;
    float refraction_index = 1.5F;
    int illumination = 2;  ///< The illumination model, 0 to 10.
    std::optional<float> exponent;
    std::optional<float> roughness;  ///< Of this and the exponent, the last one that is stated.
    std::optional<float> metallic;
    float clearcoat = 0.0F;
    float clearcoat_roughness = 0.0F;
    float sheen = 0.0F;
    std::map<std::string, std::string, std::less<>> maps;  ///< The arguments, by keyword.
};

/// Reads a statement into a material; one that is not known is ignored. False if its numbers are
/// missing or out of range.
bool read_statement(std::string_view keyword, std::string_view arguments, MtlMaterial& material);

/// The material without its textures.
[[nodiscard]] Material to_material(const MtlMaterial& mtl);

/// A map of a material library: the keyword of its statement, and what it means.
struct MtlMap {
    std::string_view keyword;
    TextureUse Material::*use;
};

/// The maps that are read.
[[nodiscard]] std::span<const MtlMap> mtl_maps();

/// The arguments of a map.
struct MtlMapArguments {
    std::string_view file;
    Wrap wrap = Wrap::repeat;
    float multiplier = 1.0F;              ///< Of a normal map.
    std::optional<std::uint8_t> channel;  ///< Of a map of numbers.
    V2f offset{0.0F, 0.0F};
    V2f scale{1.0F, 1.0F};
};

/// "-clamp on -s 1 1 1 wood grain.png": options with their arguments, then a name to the line's
/// end.
[[nodiscard]] MtlMapArguments parse_map(std::string_view arguments);

}  // namespace balcony::scene
