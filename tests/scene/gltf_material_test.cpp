// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene_files.hpp"

namespace balcony::scene::testing::gltf_material_test {

namespace {

class GltfMaterials : public SceneFiles {
protected:
    // The triangle with one material, whose JSON is given.
    [[nodiscard]] static Gltf with_material(const Json& material) {
        Gltf gltf = one_triangle();
        gltf.json["materials"] = {material};
        gltf.primitive(0)["material"] = 0;
        return gltf;
    }
};

}  // namespace

TEST_F(GltfMaterials, FactorsAreRead) {
    const auto scene = load_glb(with_material(
        {{"name", "lamp"},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
           {"metallicFactor", 0.5},
           {"roughnessFactor", 0.25}}},
         {"emissiveFactor", {1, 0.5, 0}},
         {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}}},
         {"alphaMode", "BLEND"},
         {"doubleSided", true}}));
    ASSERT_TRUE(scene) << said(scene);
    const Material& material = scene->materials[scene->meshes[0]->material.value()];
    EXPECT_EQ(material.name, "lamp");
    EXPECT_EQ(material.base_color, Color3f(0.1F, 0.2F, 0.3F));
    EXPECT_EQ(material.alpha_mode, AlphaMode::blend);
    EXPECT_EQ(material.alpha, 0.4F);
    EXPECT_EQ(material.metallic, 0.5F);
    EXPECT_EQ(material.roughness, 0.25F);
    EXPECT_EQ(material.emission, Color3f(8.0F, 4.0F, 0.0F));
    EXPECT_TRUE(material.double_sided);
    EXPECT_FALSE(scene->default_light) << "the material gives light";
}

TEST_F(GltfMaterials, DefaultsAreThoseOfGltf) {
    const auto scene = load_glb(one_triangle());
    ASSERT_TRUE(scene) << said(scene);
    const Material& material = scene->materials[scene->meshes[0]->material.value()];
    EXPECT_EQ(material.base_color, Color3f(1.0F));
    EXPECT_EQ(material.metallic, 1.0F);
    EXPECT_EQ(material.roughness, 1.0F);
    EXPECT_FALSE(material.double_sided);
    EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
    EXPECT_TRUE(scene->default_light);
    EXPECT_TRUE(scene.diagnostics.empty()) << said(scene);
}

TEST_F(GltfMaterials, AlphaIsUsedOnlyInMaskAndBlendMode) {
    const Json color = {{"baseColorFactor", {1, 1, 1, 0.3}}};
    const auto opaque = load_glb(with_material({{"pbrMetallicRoughness", color}}));
    ASSERT_TRUE(opaque);
    EXPECT_EQ(opaque->materials[0].alpha, 1.0F);
    const auto mask =
        load_glb(with_material({{"pbrMetallicRoughness", color}, {"alphaMode", "MASK"}}));
    ASSERT_TRUE(mask);
    EXPECT_EQ(mask->materials[0].alpha_mode, AlphaMode::mask);
    EXPECT_EQ(mask->materials[0].alpha, 0.3F);
    EXPECT_EQ(mask->materials[0].alpha_cutoff, 0.5F);
}

TEST_F(GltfMaterials, TexturesAreFilesOrBytes) {
    write("wood.png", "not looked at here");
    Gltf gltf = with_material(
        {{"pbrMetallicRoughness",
          {{"baseColorTexture", {{"index", 0}}}, {"metallicRoughnessTexture", {{"index", 1}}}}},
         {"emissiveTexture", {{"index", 2}}}});
    const std::size_t accessor = gltf.add_shorts({0x1234, 0x5678}, 1);
    gltf.json["images"] = {
        {{"uri", "wood.png"}},
        {{"bufferView", gltf.json["accessors"][accessor]["bufferView"]}, {"mimeType", "image/png"}},
        {{"uri", "data:image/png;base64,QUJD"}}};
    gltf.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}};
    gltf.json["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 1}}, {{"source", 2}}};
    gltf.primitive(0)["attributes"]["TEXCOORD_0"] = gltf.add_floats({0, 0, 1, 0, 0, 1}, 2);
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    const Material& material = scene->materials[0];
    const Texture& wood = scene->textures[material.base_color_texture.index.value()];
    EXPECT_EQ(wood.file, folder / "wood.png");
    EXPECT_TRUE(wood.bytes->empty());
    EXPECT_EQ(wood.wrap_u, Wrap::clamp);
    EXPECT_EQ(wood.wrap_v, Wrap::mirror);
    EXPECT_FALSE(wood.interpolated);
    const Texture& shine = scene->textures[material.roughness_texture.index.value()];
    EXPECT_EQ(*shine.bytes, (std::vector<std::uint8_t>{0x34, 0x12, 0x78, 0x56}));
    EXPECT_EQ(shine.wrap_u, Wrap::repeat);
    EXPECT_TRUE(shine.interpolated);
    EXPECT_TRUE(shine.file.empty());
    const Texture& glow = scene->textures[material.emission_texture.index.value()];
    EXPECT_EQ(*glow.bytes, (std::vector<std::uint8_t>{'A', 'B', 'C'}));
    EXPECT_TRUE(scene.diagnostics.empty()) << said(scene);
}

TEST_F(GltfMaterials, MissingTextureKeepsTheFactor) {
    write("wood.png", "");
    Gltf gltf = with_material(
        {{"name", "floor"},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {0.5, 0.25, 0, 1}}, {"baseColorTexture", {{"index", 0}}}}}});
    gltf.json["images"] = {{{"uri", "woof.png"}}};
    gltf.json["textures"] = {{{"source", 0}}};
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(says(scene, "material 'floor': its texture is skipped: there is no file '"));
    EXPECT_TRUE(says(scene, "woof.png'"));
    EXPECT_TRUE(says(scene, "did you mean '"));
    EXPECT_FALSE(scene->materials[0].base_color_texture.valid());
    EXPECT_EQ(scene->materials[0].base_color, Color3f(0.5F, 0.25F, 0.0F));
}

TEST_F(GltfMaterials, WhatIsOutOfRangeIsLimitedWithAWarning) {
    const auto load_surface = [&](double roughness, double metallic, const char* mode) {
        return load_glb(
            with_material({{"alphaMode", mode},
                           {"pbrMetallicRoughness",
                            {{"roughnessFactor", roughness}, {"metallicFactor", metallic}}}}));
    };
    const auto scene = load_surface(1e9, -2.0, "GLASS");
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(says(scene, "material 0: its 'roughnessFactor' is 1e+09 and counts as 1"));
    EXPECT_TRUE(says(scene, "material 0: its 'metallicFactor' is -2 and counts as 0"));
    EXPECT_TRUE(says(scene, "material 0: its 'alphaMode' is 'GLASS' and counts as 'OPAQUE'"));
    EXPECT_EQ(scene->materials[0].roughness, 1.0F);
    EXPECT_EQ(scene->materials[0].metallic, 0.0F);
    EXPECT_TRUE(load_surface(1.00001, -1e-9, "OPAQUE").diagnostics.empty()) << "rounding";
}

// The use of a texture maps the coordinates of the file to the place that the extension states.
TEST_F(GltfMaterials, TextureTransformIsTranslationTimesRotationTimesScale) {
    write("wood.png", "");
    // Half the size, a quarter turn counter-clockwise on the image, then to the right by 0.1.
    Gltf gltf = with_material({{"pbrMetallicRoughness",
                                {{"baseColorTexture",
                                  {{"index", 0},
                                   {"texCoord", 1},
                                   {"extensions",
                                    {{"KHR_texture_transform",
                                      {{"offset", {0.1, 0}},
                                       {"scale", {0.5, 0.5}},
                                       {"rotation", 1.5707963267948966}}}}}}}}}});
    gltf.json["images"] = {{{"uri", "wood.png"}}};
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.primitive(0)["attributes"]["TEXCOORD_0"] = gltf.add_floats({9, 9, 9, 9, 9, 9}, 2);
    gltf.primitive(0)["attributes"]["TEXCOORD_1"] = gltf.add_floats({0, 0, 1, 0, 0, 1}, 2);
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    const TextureUse& use = scene->materials[0].base_color_texture;
    const auto& coordinates = scene->meshes[0]->texture_coordinates[use.coordinates];
    constexpr float single_rounding = 1e-6F;
    const V2f expected[] = {{0.1F, 0.0F}, {0.1F, -0.5F}, {0.6F, 0.0F}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(use.place(coordinates[i]).equalWithAbsError(expected[i], single_rounding)) << i;
    }
    EXPECT_TRUE(scene.diagnostics.empty()) << said(scene);
}

TEST_F(GltfMaterials, AMeshHasTheCoordinatesThatItsTexturesUse) {
    write("wood.png", "");
    Gltf gltf = with_material(
        {{"name", "wall"},
         {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 2}}}}},
         {"normalTexture", {{"index", 0}}},
         {"emissiveTexture", {{"index", 0}, {"texCoord", 1}}}});
    gltf.json["images"] = {{{"uri", "wood.png"}}};
    gltf.json["textures"] = {{{"source", 0}}};
    for (const char* set : {"TEXCOORD_0", "TEXCOORD_1", "TEXCOORD_2"}) {
        const auto number = static_cast<float>(set[9] - '0');
        gltf.primitive(0)["attributes"][set] = gltf.add_floats({number, 0, 0, 1, 1, 0}, 2);
    }
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    const Material& material = scene->materials[0];
    const Mesh& mesh = scene->meshes[0];
    const auto first = [&](const TextureUse& use) {
        return mesh.texture_coordinates[use.coordinates][0];
    };
    EXPECT_EQ(first(material.base_color_texture), V2f(2.0F, 0.0F));
    EXPECT_EQ(first(material.emission_texture), V2f(1.0F, 0.0F));
    EXPECT_FALSE(material.normal_texture.valid());
    EXPECT_TRUE(says(scene,
                     "material 'wall': its 'normalTexture' is skipped: it uses TEXCOORD_0, and a "
                     "material has at most 2 sets"));
}

TEST_F(GltfMaterials, MissingCoordinatesAreReported) {
    write("wood.png", "");
    Gltf gltf = with_material({{"normalTexture", {{"index", 0}, {"texCoord", 1}}}});
    gltf.json["images"] = {{{"uri", "wood.png"}}};
    gltf.json["textures"] = {{{"source", 0}}};
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(says(scene, "mesh 'mesh' has no TEXCOORD_1, which the textures of its material"));
}

TEST_F(GltfMaterials, VertexColorsHaveAlpha) {
    Gltf gltf = one_triangle();
    gltf.primitive(0)["attributes"]["COLOR_0"] =
        gltf.add_floats({1, 0, 0, 0.25, 0, 1, 0, 0.5, 0, 0, 1, 7}, 4);
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->meshes[0]->colors,
              (std::vector<Color4f>{{1, 0, 0, 0.25F}, {0, 1, 0, 0.5F}, {0, 0, 1, 1}}));
}

TEST_F(GltfMaterials, UnsupportedFeaturesAreReported) {
    Gltf gltf = with_material({{"name", "wall"}});
    gltf.json["extensionsUsed"] = {"KHR_materials_iridescence", "KHR_lights_punctual"};
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(says(scene, "extensions that are not supported: 'KHR_materials_iridescence'\n"));
}

TEST_F(GltfMaterials, ABadMaterialIsReplaced) {
    const auto scene =
        load_glb(with_material({{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0}}}}}));
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_TRUE(
        says(scene,
             "material 0 is replaced by glTF's default material: its 'baseColorFactor' has 3 "
             "numbers where 4 are required"));
    EXPECT_EQ(scene->materials[0].base_color, Color3f(1.0F));
}

}  // namespace balcony::scene::testing::gltf_material_test
