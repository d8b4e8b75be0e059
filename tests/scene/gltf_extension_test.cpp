// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The extensions of glTF's materials.

#include <cmath>

#include "scene_files.hpp"

namespace balcony::scene::testing::gltf_extension_test {

namespace {

class GltfExtensions : public SceneFiles {
protected:
    // The triangle with a material that has one extension, and textures 0 to 2.
    [[nodiscard]] Gltf with(const std::string& extension, const Json& content) const {
        write("image.png", "not looked at here");
        Gltf gltf = one_triangle();
        gltf.json["materials"] = {{{"name", "m"},
                                   {"emissiveFactor", {1, 0.5, 0}},
                                   {"extensions", {{extension, content}}}}};
        gltf.json["images"] = {{{"uri", "image.png"}}};
        gltf.json["textures"] = {{{"source", 0}}, {{"source", 0}}, {{"source", 0}}};
        gltf.json["extensionsUsed"] = {extension};
        gltf.primitive(0)["material"] = 0;
        gltf.primitive(0)["attributes"]["TEXCOORD_0"] = gltf.add_floats({0, 0, 1, 0, 0, 1}, 2);
        return gltf;
    }

    // Its material; fails on any warning.
    [[nodiscard]] Material material(const std::string& extension, const Json& content) const {
        const auto scene = load_glb(with(extension, content));
        EXPECT_TRUE(scene) << said(scene);
        EXPECT_TRUE(scene.diagnostics.empty()) << said(scene);
        return scene ? scene->materials[0] : Material();
    }
};

// An extension with a value of each of its members.
struct Example {
    const char* extension;
    Json content;
};

std::vector<Example> examples() {
    const Json texture = {{"index", 0}};
    Json moved = {{"index", 0}, {"scale", 0.5}};
    moved["extensions"]["KHR_texture_transform"]["offset"] = {0.25, 0};
    return {{"KHR_materials_clearcoat",
             {{"clearcoatFactor", 0.5},
              {"clearcoatRoughnessFactor", 0.25},
              {"clearcoatTexture", texture},
              {"clearcoatRoughnessTexture", texture},
              {"clearcoatNormalTexture", moved}}},
            {"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}},
            {"KHR_materials_ior", {{"ior", 1.25}}},
            {"KHR_materials_sheen",
             {{"sheenColorFactor", {1, 0.5, 0.25}},
              {"sheenRoughnessFactor", 0.75},
              {"sheenColorTexture", texture},
              {"sheenRoughnessTexture", texture}}},
            {"KHR_materials_specular",
             {{"specularFactor", 0.5},
              {"specularColorFactor", {2, 1, 0.5}},
              {"specularTexture", texture},
              {"specularColorTexture", texture}}},
            {"KHR_materials_transmission",
             {{"transmissionFactor", 0.75}, {"transmissionTexture", texture}}},
            {"KHR_materials_unlit", Json::object()},
            {"KHR_materials_volume",
             {{"thicknessFactor", 2},
              {"attenuationDistance", 0.5},
              {"attenuationColor", {1, 0.5, 0.25}}}}};
}

}  // namespace

TEST_F(GltfExtensions, ClearcoatIsRead) {
    const Material m = material(examples()[0].extension, examples()[0].content);
    EXPECT_EQ(m.clearcoat, 0.5F);
    EXPECT_EQ(m.clearcoat_roughness, 0.25F);
    EXPECT_TRUE(m.clearcoat_texture.valid());
    EXPECT_EQ(m.clearcoat_texture.channel, 0);
    EXPECT_EQ(m.clearcoat_roughness_texture.channel, 1);
    EXPECT_TRUE(m.clearcoat_normal_texture.valid());
    EXPECT_EQ(m.clearcoat_normal_texture.encoding, TextureEncoding::linear);
    EXPECT_EQ(m.clearcoat_normal_texture.place({0.0F, 0.0F}).x, 0.25F);
    EXPECT_EQ(m.clearcoat_normal_scale, 0.5F);
    EXPECT_FALSE(m.normal_texture.valid());
}

TEST_F(GltfExtensions, SheenIsRead) {
    const Material m = material(examples()[3].extension, examples()[3].content);
    EXPECT_EQ(m.sheen_color, Color3f(1.0F, 0.5F, 0.25F));
    EXPECT_EQ(m.sheen_roughness, 0.75F);
    EXPECT_EQ(m.sheen_color_texture.encoding, TextureEncoding::srgb);
    EXPECT_EQ(m.sheen_roughness_texture.encoding, TextureEncoding::linear);
    EXPECT_EQ(m.sheen_roughness_texture.channel, 3);
}

TEST_F(GltfExtensions, SpecularIsRead) {
    const Material m = material(examples()[4].extension, examples()[4].content);
    EXPECT_EQ(m.specular, 0.5F);
    EXPECT_EQ(m.specular_color, Color3f(2.0F, 1.0F, 0.5F));
    EXPECT_EQ(m.specular_texture.channel, 3);
    EXPECT_EQ(m.specular_color_texture.encoding, TextureEncoding::srgb);
}

TEST_F(GltfExtensions, TransmissionAndUnlitAreRead) {
    const Material glass = material(examples()[5].extension, examples()[5].content);
    EXPECT_EQ(glass.transmission, 0.75F);
    EXPECT_TRUE(glass.transmission_texture.valid());
    EXPECT_TRUE(glass.thin_walled) << "without a volume";
    EXPECT_TRUE(material("KHR_materials_unlit", Json::object()).unlit);
}

TEST_F(GltfExtensions, AnIndexOf0IsAFullReflectance) {
    EXPECT_EQ(material("KHR_materials_ior", {{"ior", 1.25}}).ior, 1.25F);
    const double ior = double{material("KHR_materials_ior", {{"ior", 0}}).ior};
    // 4 / ior.
    EXPECT_NEAR(std::pow((ior - 1.0) / (ior + 1.0), 2.0), 1.0, 4.1e-4);
}

// Light that travels the attenuation distance has the attenuation colour.
TEST_F(GltfExtensions, AttenuationAtItsDistanceEqualsItsColor) {
    const Material m = material(examples()[7].extension, examples()[7].content);
    EXPECT_FALSE(m.thin_walled);
    constexpr float distance = 0.5F;
    const Color3f kept(std::exp(-distance * m.absorption.x), std::exp(-distance * m.absorption.y),
                       std::exp(-distance * m.absorption.z));
    EXPECT_EQ(kept.x, 1.0F);
    EXPECT_NEAR(kept.y, 0.5F, 1e-6F) << "single rounding";
    EXPECT_NEAR(kept.z, 0.25F, 1e-6F);
    const Material clear = material("KHR_materials_volume", {{"thicknessFactor", 1}});
    EXPECT_EQ(clear.absorption, Color3f(0.0F)) << "the distance is infinite";
    EXPECT_TRUE(material("KHR_materials_volume", Json::object()).thin_walled);
}

// A member of a wrong kind is a warning, and the material keeps everything else.
TEST_F(GltfExtensions, AWrongMemberSkipsItsExtensionOnly) {
    const std::vector<Json> wrong{"text", Json::array({"a", "b", "c"}), Json::object(), true,
                                  -1e300, Json::array({1e300, 1, 1})};
    for (const auto& [extension, content] : examples()) {
        for (const auto& [key, value] : content.items()) {
            for (const Json& replacement : wrong) {
                // Numbers are clamped, and a texture is an object.
                if (replacement.type() == value.type() ||
                    (replacement.is_number() && value.is_number())) {
                    continue;
                }
                Json changed = content;
                changed[key] = replacement;
                const auto scene = load_glb(with(extension, changed));
                ASSERT_TRUE(scene) << extension << key << replacement;
                EXPECT_TRUE(says(scene, "material 'm': its ")) << extension << key << replacement;
                EXPECT_EQ(scene->materials[0].emission, Color3f(1.0F, 0.5F, 0.0F))
                    << extension << key << replacement;
            }
        }
    }
}

TEST_F(GltfExtensions, ValuesOutOfRangeAreReported) {
    const std::tuple<const char*, Json, const char*> files[] = {
        {"KHR_materials_emissive_strength",
         {{"emissiveStrength", 1e300}},
         "'emissiveStrength' is not in the range"},
        {"KHR_materials_emissive_strength",
         {{"emissiveStrength", -1}},
         "'emissiveStrength' is not in the range"},
        {"KHR_materials_ior", {{"ior", 0.5}}, "its 'ior' is less than 1"},
        {"KHR_materials_volume",
         {{"attenuationDistance", 0}},
         "its 'attenuationDistance' is not positive"},
        {"KHR_materials_volume",
         {{"attenuationColor", {-1, 0, 0}}},
         "'attenuationColor' is not in the range"},
        {"KHR_materials_unlit", 7, "it is not an object"}};
    for (const auto& [extension, content, message] : files) {
        const auto scene = load_glb(with(extension, content));
        ASSERT_TRUE(scene) << extension;
        EXPECT_TRUE(says(scene, message)) << extension;
    }
}

// A scene that is written and read again has the same material.
TEST_F(GltfExtensions, AMaterialSurvivesWriting) {
    Gltf gltf = with("KHR_materials_unlit", Json::object());
    Json& material = gltf.json["materials"][0];
    for (const auto& [extension, content] : examples()) {
        material["extensions"][extension] = content;
    }
    const Json turned = {{"index", 0},
                         {"extensions",
                          {{"KHR_texture_transform",
                            {{"offset", {0.1, 0.2}}, {"scale", {2, -3}}, {"rotation", 0.5}}}}}};
    material["normalTexture"] = turned;
    material["normalTexture"]["scale"] = 0.5;
    material["pbrMetallicRoughness"] = {{"metallicRoughnessTexture", turned}};
    auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    for (Texture& texture : scene->textures) {
        texture.file.clear();
        texture.bytes = std::vector<std::uint8_t>{1, 2, 3};
    }
    const auto again = load("again.glb", to_glb(*scene));
    ASSERT_TRUE(again) << said(again);
    EXPECT_TRUE(again.diagnostics.empty()) << said(again);
    const Material& before = scene->materials[0];
    const Material& after = again->materials[0];
    // A few roundings of sines and logarithms.
    constexpr float tolerance = 1e-6F;
    for (const auto use : texture_uses) {
        const TextureUse& a = before.*use;
        const TextureUse& b = after.*use;
        EXPECT_EQ(a.valid(), b.valid());
        EXPECT_EQ(a.channel, b.channel);
        EXPECT_EQ(a.encoding, b.encoding);
        for (const V2f& point : {V2f(0.0F, 0.0F), V2f(1.0F, 0.0F), V2f(0.0F, 1.0F)}) {
            EXPECT_TRUE(a.place(point).equalWithAbsError(b.place(point), 3.0F * tolerance));
        }
    }
    EXPECT_TRUE(before.emission.equalWithRelError(after.emission, tolerance));
    EXPECT_TRUE(before.absorption.equalWithAbsError(after.absorption, 4.0F * tolerance))
        << before.absorption << after.absorption;
    EXPECT_EQ(before.specular_color, after.specular_color);
    EXPECT_EQ(before.sheen_color, after.sheen_color);
    for (const auto part :
         {&Material::normal_scale, &Material::ior, &Material::specular, &Material::transmission,
          &Material::clearcoat, &Material::clearcoat_roughness, &Material::clearcoat_normal_scale,
          &Material::sheen_roughness}) {
        EXPECT_EQ(before.*part, after.*part);
    }
    EXPECT_EQ(before.thin_walled, after.thin_walled);
    EXPECT_EQ(before.unlit, after.unlit);
}

}  // namespace balcony::scene::testing::gltf_extension_test
