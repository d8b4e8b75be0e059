// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <numbers>
#include <optional>

#include "scene_files.hpp"

namespace balcony::scene::testing::light_test {

namespace {

class Lights : public SceneFiles {
protected:
    [[nodiscard]] static Gltf with_light(const Json& light, Json node) {
        Gltf gltf = one_triangle();
        gltf.json["extensions"]["KHR_lights_punctual"]["lights"] = {light};
        node["extensions"]["KHR_lights_punctual"]["light"] = 0;
        gltf.add_node(node);
        return gltf;
    }
};

// Directions are made of a few products of numbers near one.
constexpr double rounding = 1e-12;

}  // namespace

TEST_F(Lights, PositionAndDirectionFollowTheNode) {
    const double half = std::sqrt(0.5);
    // A quarter turn about x takes -z to +y; the scale must change neither direction's length nor
    // the intensity.
    const auto scene =
        load_glb(with_light({{"type", "spot"},
                             {"intensity", 40},
                             {"color", {1, 0.5, 0.25}},
                             {"range", 7},
                             {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.4}}}},
                            {{"name", "lamp"},
                             {"translation", {1, 2, 3}},
                             {"rotation", {half, 0, 0, half}},
                             {"scale", {3, 3, 3}}}));
    ASSERT_TRUE(scene) << said(scene);
    ASSERT_EQ(scene->lights.size(), 1U);
    const Light& light = scene->lights[0];
    EXPECT_EQ(light.name, "lamp");
    EXPECT_EQ(light.kind, LightKind::spot);
    EXPECT_EQ(light.position, V3d(1, 2, 3));
    EXPECT_TRUE(light.direction.equalWithAbsError(V3d(0, 1, 0), rounding));
    EXPECT_EQ(light.intensity, Color3f(40.0F, 20.0F, 10.0F));
    EXPECT_EQ(light.range, 7.0F);
    EXPECT_EQ(light.inner_cone, 0.2F);
    EXPECT_EQ(light.outer_cone, 0.4F);
    EXPECT_FALSE(scene->default_light);
}

TEST_F(Lights, DefaultsAreThoseOfTheExtension) {
    for (const char* type : {"point", "spot", "directional"}) {
        const auto scene = load_glb(with_light({{"type", type}, {"name", "sun"}}, Json::object()));
        ASSERT_TRUE(scene) << said(scene);
        ASSERT_EQ(scene->lights.size(), 1U);
        const Light& light = scene->lights[0];
        EXPECT_EQ(light.name, "sun");
        EXPECT_EQ(light.kind, std::string_view(type) == "point"  ? LightKind::point
                              : std::string_view(type) == "spot" ? LightKind::spot
                                                                 : LightKind::directional);
        EXPECT_EQ(light.intensity, Color3f(1.0F));
        EXPECT_EQ(light.range, 0.0F);
        EXPECT_EQ(light.direction, V3d(0, 0, -1));
        EXPECT_EQ(light.inner_cone, 0.0F);
        EXPECT_FLOAT_EQ(light.outer_cone, std::numbers::pi_v<float> / 4.0F);
    }
}

TEST_F(Lights, LightsOfOneNameStayApart) {
    Gltf gltf = with_light({{"type", "point"}}, {{"name", "node"}, {"translation", {5, 0, 0}}});
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->lights[0].position, V3d(5, 0, 0)) << "not where the mesh of that name is";
}

TEST_F(Lights, EmissionOfBlenderIsInTheirUnits) {
    Gltf gltf = with_light({{"type", "point"}}, Json::object());
    gltf.json["materials"] = {{{"emissiveFactor", {1, 0.5, 0}}}};
    gltf.primitive(0)["material"] = 0;
    const auto emission = [&](const Json& generator, std::optional<float> scale = {}) {
        gltf.json["asset"]["generator"] = generator;
        const auto scene = load(write("lit.glb", gltf.glb()), {}, {}, {.emission_scale = scale});
        EXPECT_TRUE(scene) << said(scene);
        EXPECT_EQ(scene->materials[0].emission.y, 0.5F * scene->emission_scale);
        return scene->materials[0].emission.x;
    };
    EXPECT_EQ(emission("Khronos glTF Blender I/O v3.4.50"), 683.0F);
    EXPECT_EQ(emission("Khronos glTF Blender I/O v4.2.70"), 683.0F);
    EXPECT_EQ(emission("Khronos glTF Blender I/O v10.0"), 683.0F);
    EXPECT_EQ(emission("Khronos glTF Blender I/O v3.3.27"), 1.0F) << "converts no lights";
    EXPECT_EQ(emission("Khronos glTF Blender I/O"), 1.0F);
    EXPECT_EQ(emission("Balcony"), 1.0F);
    EXPECT_EQ(emission(3), 1.0F);
    EXPECT_EQ(emission("Khronos glTF Blender I/O v3.4.50", 2.0F), 2.0F);
    EXPECT_EQ(emission("Balcony", 2.0F), 2.0F);
    EXPECT_EQ(emission("Balcony", 1e30F), 1e30F);
    gltf.json["materials"][0]["emissiveFactor"] = {1, 1, 1};
    gltf.json["materials"][0]["extensions"]["KHR_materials_emissive_strength"] = {
        {"emissiveStrength", 1e6}};
    gltf.json["extensionsUsed"].push_back("KHR_materials_emissive_strength");
    const auto bright = load(write("lit.glb", gltf.glb()), {}, {}, {.emission_scale = 1e30F});
    ASSERT_TRUE(bright) << said(bright);
    EXPECT_EQ(bright->materials[0].emission, Color3f(static_cast<float>(max_quantity)));
}

TEST_F(Lights, EmissionOfBlenderWithoutLightsIsAsWritten) {
    Gltf gltf = one_triangle();
    gltf.json["asset"]["generator"] = "Khronos glTF Blender I/O v3.4.50";
    gltf.json["materials"] = {{{"emissiveFactor", {1, 1, 1}}}};
    gltf.primitive(0)["material"] = 0;
    const auto scene = load_glb(gltf);
    ASSERT_TRUE(scene) << said(scene);
    EXPECT_EQ(scene->materials[0].emission, Color3f(1.0F));
    EXPECT_FALSE(scene->default_light);
    const auto dark = load(write("dark.glb", gltf.glb()), {}, {}, {.emission_scale = 0.0F});
    ASSERT_TRUE(dark) << said(dark);
    EXPECT_TRUE(dark->default_light);
}

TEST_F(Lights, BadLightsAreLeftOut) {
    const auto unknown = load_glb(with_light({{"type", "area"}}, {{"name", "lamp"}}));
    ASSERT_TRUE(unknown);
    EXPECT_TRUE(says(unknown, "light 'lamp' is skipped: its type 'area' is unknown"));
    EXPECT_TRUE(unknown->default_light);
    const auto negative =
        load_glb(with_light({{"type", "point"}, {"intensity", -1}}, {{"name", "lamp"}}));
    ASSERT_TRUE(negative);
    EXPECT_TRUE(says(negative, "light 'lamp' is skipped: its 'intensity' is not in the range 0"));
}

}  // namespace balcony::scene::testing::light_test
