// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/scene_edits.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "balcony/motion.hpp"
#include "scene_files.hpp"

namespace balcony::scene::testing::scene_edits_test {

namespace {

using Edits = SceneFiles;
using Values = std::vector<PropertyValue>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

M44d shifted(double x, double y, double z) { return M44d().translate(V3d(x, y, z)); }
M44d scaled(double by) { return M44d().scale(V3d(by)); }

/// A quarter turn about z, then a shift.
M44d turned_and_shifted() {
    return M44d().rotate(V3d(0.0, 0.0, std::numbers::pi / 2.0)) * shifted(1.0, 2.0, 3.0);
}

bool are_near(const M44d& a, const M44d& b, double tolerance = 1e-12) {
    return a.equalWithAbsError(b, tolerance);
}

/// Of an error that is the only one.
std::string message_of(const Diagnostics& found) {
    EXPECT_EQ(found.size(), 1U) << to_text(found);
    return found.empty() ? "" : found.front().message + " " + found.front().remedy;
}

::testing::AssertionResult contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos ? ::testing::AssertionSuccess()
                                                : ::testing::AssertionFailure() << text;
}

/// An arm that turns, on which a hand, a tool and a lamp hang, and a stone that lies still.
Gltf arm() {
    Gltf gltf;
    const std::size_t mesh = gltf.add_triangle("mesh");
    gltf.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}}};
    gltf.add_node({{"name", "arm"}, {"children", {1, 2, 3}}, {"translation", {5, 0, 0}}});
    gltf.add_node({{"name", "hand"}, {"mesh", mesh}, {"translation", {1, 0, 0}}}, false);
    gltf.add_node({{"name", "tool"}, {"mesh", mesh}, {"translation", {2, 0, 0}}}, false);
    gltf.add_node({{"name", "lamp"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}},
                  false);
    gltf.add_node({{"name", "stone"}, {"mesh", gltf.add_triangle("stone")}});
    const auto half = static_cast<float>(std::sqrt(0.5));
    gltf.json["animations"] = {
        {{"name", "turns"},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}},
         {"samplers",
          {{{"input", gltf.add_floats({0, 2}, 1)},
            {"output", gltf.add_floats({0, 0, 0, 1, 0, 0, half, half}, 4)}}}}}};
    return gltf;
}

std::size_t object_in(const Scene& scene, const char* name) { return *find_object(scene, name); }

M44d place_at(const Scene& scene, const char* name, double time) {
    return *place_of(*moved_to(scene, time), object_in(scene, name));
}

const std::vector<V3d> corners{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
const std::vector<std::array<std::int64_t, 3>> faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

Scene tetrahedron() {
    Scene scene;
    scene.materials.emplace_back().name = "clay";
    EXPECT_TRUE(add_object(scene, "body", {.positions = corners, .triangles = faces}, 0));
    return scene;
}

}  // namespace

TEST_F(Edits, AreToldApartByTheirContent) {
    const auto make = [](const Values& wood, const Values& lamp, const M44d& place) {
        Scene scene;
        const std::vector<V3d> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        const std::vector<std::array<std::int64_t, 3>> faces{{0, 1, 2}};
        const std::size_t material = *add_material(scene, "wood", wood);
        EXPECT_TRUE(
            add_object(scene, "leaf", {.positions = corners, .triangles = faces}, material, place));
        EXPECT_TRUE(add_light(scene, "lamp", LightKind::point, lamp));
        return scene;
    };
    const Values wood{{"roughness", {0.5}}};
    const Values lamp{{"intensity", {5}}};
    const Scene scene = make(wood, lamp, shifted(1, 2, 3));
    EXPECT_EQ(content_hash(scene), content_hash(make(wood, lamp, shifted(1, 2, 3))));
    std::vector<Scene> others{make({{"roughness", {0.6}}}, lamp, shifted(1, 2, 3)),
                              make(wood, {{"intensity", {6}}}, shifted(1, 2, 3)),
                              make(wood, lamp, shifted(1, 2, 4)),
                              scene,
                              scene,
                              scene};
    others[3].meshes[0].edit().positions[1].x = 2.0F;
    others[4].objects[0].name = "petal";
    others[5].lights[0].kind = LightKind::spot;
    for (const Scene& other : others) {
        EXPECT_NE(content_hash(other), content_hash(scene));
    }
}

TEST_F(Edits, PartsAreFoundByNameOrNumber) {
    Scene scene = *load_glb(arm());
    EXPECT_EQ(scene.objects[object_in(scene, "tool")].name, "tool");
    EXPECT_EQ(*find_object(scene, std::size_t{2}), 2U);
    EXPECT_TRUE(contains(message_of(find_object(scene, "tol").diagnostics),
                         "has no object 'tol' did you mean 'tool'?"));
    EXPECT_TRUE(
        contains(message_of(find_light(scene, "x").diagnostics), "it has the lights 'lamp'"));
    EXPECT_TRUE(contains(message_of(find_object(scene, std::size_t{3}).diagnostics),
                         "no object 3 it has 3 objects"));
    scene.objects[2].name = "hand";
    EXPECT_TRUE(contains(message_of(find_object(scene, "hand").diagnostics),
                         "has 2 objects 'hand' give its number; the first of them is 0"));
}

TEST_F(Edits, AnObjectIsMovedWithoutTheOthersAndWithoutCopies) {
    const Scene before = *load_obj(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\no a\nf 1 2 3\nusemtl m\n"
        "f 1 2 4\no b\nf 2 3 4\n");
    ASSERT_EQ(before.instances.size(), 3U);
    Scene scene = before;
    const M44d change = scaled(2.0) * shifted(1.0, 2.0, 3.0);
    EXPECT_TRUE(transform_object(scene, object_in(scene, "a"), change).empty());
    EXPECT_EQ(bounds_of(scene, object_in(scene, "a")), Box3f(V3f(1, 2, 3), V3f(3, 4, 7)));
    EXPECT_EQ(bounds_of(scene, object_in(scene, "b")), bounds_of(before, 1));
    EXPECT_EQ(bounds_of(before, 0), Box3f(V3f(0, 0, 0), V3f(1, 1, 2)));
    EXPECT_EQ(*place_of(scene, 0), change);
    EXPECT_TRUE(place_object(scene, 0, M44d()).empty());
    EXPECT_EQ(bounds_of(scene, 0), bounds_of(before, 0));
}

TEST_F(Edits, WhatMovesKeepsMovingOnATransformedPath) {
    const Scene before = *load_glb(arm());
    Scene scene = *moved_to(before, 0.7);
    const M44d change = turned_and_shifted();
    EXPECT_TRUE(transform_object(scene, object_in(scene, "hand"), change).empty());
    EXPECT_TRUE(are_near(*place_of(scene, object_in(scene, "hand")),
                         place_at(before, "hand", 0.7) * change));
    for (const double time : {0.0, 0.5, 0.7, 1.3, 2.0}) {
        EXPECT_TRUE(
            are_near(place_at(scene, "hand", time), place_at(before, "hand", time) * change));
        for (const char* const other : {"tool", "stone"}) {
            EXPECT_EQ(place_at(scene, other, time), place_at(before, other, time)) << other;
        }
        EXPECT_EQ(moved_to(scene, time)->lights, moved_to(before, time)->lights);
    }
    // The hand has nodes of its own by now.
    const std::size_t nodes = scene.motion->nodes.size();
    for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(transform_object(scene, object_in(scene, "hand"), change).empty());
    }
    EXPECT_EQ(scene.motion->nodes.size(), nodes);
    EXPECT_TRUE(are_near(place_at(scene, "hand", 1.0),
                         place_at(before, "hand", 1.0) * change * change * change * change));
    EXPECT_EQ(place_at(scene, "tool", 1.0), place_at(before, "tool", 1.0));
}

TEST_F(Edits, WhatIsPlacedStandsThereAtAllTimes) {
    const Scene before = *load_glb(arm());
    Scene scene = before;
    EXPECT_TRUE(place_object(scene, object_in(scene, "tool"), turned_and_shifted()).empty());
    for (const double time : {0.0, 1.0, 2.0}) {
        EXPECT_EQ(place_at(scene, "tool", time), turned_and_shifted());
        EXPECT_EQ(place_at(scene, "hand", time), place_at(before, "hand", time));
    }
    EXPECT_TRUE(place_object(scene, object_in(scene, "hand"), M44d()).empty());
    EXPECT_TRUE(set_light(scene, 0, Values{{"position", {1, 2, 3}}}).empty());
    EXPECT_EQ(scene.motion, nullptr) << "nothing moves any more";
    EXPECT_EQ(moved_to(scene, 1.0)->lights[0].position, V3d(1, 2, 3));
    EXPECT_NE(before.motion, nullptr);
}

// Joints place the vertices of a mesh in the world, which its instance then moves.
TEST_F(Edits, AMeshThatFollowsJointsIsTransformed) {
    Scene before = tetrahedron();
    Motion motion;
    motion.tracks = {{.width = 3, .times = {0.0, 1.0}, .values = {0, 0, 0, 4, 0, 0}}};
    motion.nodes.emplace_back().translation_track = TrackIndex(0);
    const Mesh& mesh = before.meshes[0];
    Deformation& follows = motion.deformations.emplace_back();
    follows.mesh = MeshIndex(0);
    follows.positions = mesh.positions;
    follows.normals = mesh.normals;
    follows.joints = {{NodeIndex(0), M44d()}};
    follows.influences.assign(mesh.positions.size(), {0, 1.0F});
    before.motion = std::make_shared<const Motion>(motion);
    EXPECT_EQ(bounds_of(*moved_to(before, 0.5), 0), Box3f(V3f(2, 0, 0), V3f(3, 1, 1)));
    Scene scene = before;
    EXPECT_TRUE(transform_object(scene, 0, scaled(2.0) * shifted(0, 0, 10)).empty());
    EXPECT_EQ(bounds_of(*moved_to(scene, 0.5), 0), Box3f(V3f(4, 0, 10), V3f(6, 2, 12)));
    // (x, y, z) is (x, -z, y) in axes with z up.
    Scene upright;
    upright.axes = Axes::z_up;
    add_scene(upright, scene);
    EXPECT_EQ(bounds_of(*moved_to(upright, 0.5), 0), Box3f(V3f(4, -12, 0), V3f(6, -10, 2)));
}

TEST_F(Edits, AnObjectThatCannotStandThereStays) {
    Scene scene = *load_glb(arm());
    M44d projective;
    projective[0][3] = 0.5;
    const std::vector<std::pair<M44d, const char*>> wrong{
        {M44d().scale(V3d(1.0, 0.0, 1.0)), "singular"},
        {shifted(nan, 0.0, 0.0), "not finite"},
        {shifted(2e12, 0.0, 0.0), "further than 1e+12"},
        {scaled(1e10), "scales beyond"},
        {projective, "not affine"}};
    for (const auto& [matrix, fault] : wrong) {
        for (const char* const name : {"stone", "hand"}) {
            const M44d before = *place_of(scene, object_in(scene, name));
            EXPECT_TRUE(
                contains(message_of(place_object(scene, object_in(scene, name), matrix)), fault));
            EXPECT_TRUE(contains(
                message_of(transform_object(scene, object_in(scene, name), matrix)), fault));
            EXPECT_EQ(*place_of(scene, object_in(scene, name)), before);
        }
    }
    EXPECT_EQ(scene.motion->instances.size(), 2U);
}

TEST_F(Edits, TheOthersRemainAfterARemoval) {
    const Scene before = *load_glb(arm());
    Scene scene = before;
    remove_object(scene, object_in(scene, "hand"));
    EXPECT_TRUE(check(scene).empty());
    EXPECT_FALSE(find_object(scene, "hand"));
    EXPECT_EQ(scene.meshes.size(), 2U) << "the tool has the mesh of the hand";
    for (const double time : {0.0, 1.0}) {
        for (const char* const other : {"tool", "stone"}) {
            EXPECT_EQ(place_at(scene, other, time), place_at(before, other, time)) << other;
        }
    }
    remove_object(scene, object_in(scene, "tool"));
    EXPECT_EQ(scene.meshes.size(), 1U);
    EXPECT_EQ(scene.meshes[0]->name, "stone");
    EXPECT_TRUE(scene.motion->instances.empty());
    remove_light(scene, 0);
    EXPECT_EQ(scene.motion, nullptr);
    EXPECT_TRUE(scene.default_light);
    remove_object(scene, 0);
    EXPECT_TRUE(scene.instances.empty() && scene.objects.empty() && scene.meshes.empty());
    EXPECT_EQ(before.instances.size(), 3U);
}

TEST_F(Edits, ArraysAreTheMeshOfAFile) {
    const Scene file = *load_obj(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no body\nf 1 3 2\nf 1 2 4\n"
        "f 2 3 4\nf 3 1 4\n");
    const Scene made = tetrahedron();
    const Mesh& of_file = file.meshes[0];
    const Mesh& of_arrays = made.meshes[0];
    EXPECT_EQ(of_arrays.positions, of_file.positions);
    EXPECT_EQ(of_arrays.normals, of_file.normals);
    EXPECT_EQ(of_arrays.triangles, of_file.triangles);
    EXPECT_EQ(made.objects[0].name, "body");
    EXPECT_TRUE(check(made).empty());
}

TEST_F(Edits, ArraysByVertexBelongToTheirVertices) {
    Scene scene = tetrahedron();
    const std::vector<V3d> normals{{0, 0, 5}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}};
    const std::vector<Imath::V2d> places{{0, 0}, {0.25, 0}, {0, 0.5}, {1, 1}};
    const std::vector<double> colors{0, 0, 0, 1, 1, 0, 0, 0.5, 0, 1, 0, 1, 0, 0, 1, 1};
    const auto added = add_object(scene, "smooth", {corners, faces, normals, places, colors, 4}, 0,
                                  shifted(0, 0, 7));
    ASSERT_TRUE(added && added.diagnostics.empty());
    const Mesh& mesh = scene.meshes[1];
    EXPECT_EQ(mesh.positions.size(), 4U);
    EXPECT_EQ(mesh.normals[1], V3f(1, 0, 0));
    EXPECT_EQ(mesh.texture_coordinates[0][2], V2f(0, 0.5F));
    EXPECT_EQ(mesh.colors[1], Color4f(1, 0, 0, 0.5F));
    EXPECT_EQ(bounds_of(scene, *added), Box3f(V3f(0, 0, 7), V3f(1, 1, 8)));
}

TEST_F(Edits, ArraysThatAreNoMeshAreRefused) {
    using Change = std::function<void(MeshArrays&)>;
    static const std::vector<V3d> not_finite{{0, 0, 0}, {1, 0, 0}, {0, nan, 0}, {0, 0, 1}};
    static const std::vector<V3d> too_far{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1e39}};
    static const std::vector<std::array<std::int64_t, 3>> past_end{{0, 1, 2}, {0, 1, 4}};
    static const std::vector<std::array<std::int64_t, 3>> negative{{0, 1, -1}};
    static const std::vector<std::array<std::int64_t, 3>> flat{{0, 1, 1}};
    static const std::vector<V3d> few(3, V3d(1.0));
    static const std::vector<V3d> zeros(4, V3d(0.0));
    static const std::vector<Imath::V2d> bad_places{{0, 0}, {nan, 0}, {0, 0}, {0, 0}};
    static const std::vector<double> bad_colors{1, 1, 1, 1, 1, 1, 1, 2, 1, 1, 1, 1};
    const std::vector<std::pair<const char*, Change>> wrong{
        {"row 2 of the positions is not finite", [](MeshArrays& m) { m.positions = not_finite; }},
        {"row 3 of the positions is not finite", [](MeshArrays& m) { m.positions = too_far; }},
        {"row 1 of the triangles names a vertex that is not there: there are 4",
         [](MeshArrays& m) { m.triangles = past_end; }},
        {"row 0 of the triangles", [](MeshArrays& m) { m.triangles = negative; }},
        {"has no triangles", [](MeshArrays& m) { m.triangles = {}; }},
        {"no triangle has an area", [](MeshArrays& m) { m.triangles = flat; }},
        {"3 rows of the normals, but 4 positions", [](MeshArrays& m) { m.normals = few; }},
        {"row 0 of the normals has no length", [](MeshArrays& m) { m.normals = zeros; }},
        {"row 1 of the texture coordinates",
         [](MeshArrays& m) { m.texture_coordinates = bad_places; }},
        {"row 2 of the colours is not from 0 to 1", [](MeshArrays& m) { m.colors = bad_colors; }},
    };
    for (const auto& [fault, change] : wrong) {
        Scene scene = tetrahedron();
        MeshArrays arrays{.positions = corners, .triangles = faces};
        change(arrays);
        SCOPED_TRACE(fault);
        EXPECT_TRUE(contains(message_of(add_object(scene, "other", arrays, 0).diagnostics), fault));
        EXPECT_EQ(scene.objects.size(), 1U);
        EXPECT_EQ(scene.meshes.size(), 1U);
    }
    Scene scene = tetrahedron();
    const MeshArrays arrays{.positions = corners, .triangles = faces};
    EXPECT_TRUE(contains(message_of(add_object(scene, "body", arrays, 0).diagnostics), "already"));
    EXPECT_TRUE(contains(message_of(add_object(scene, "", arrays, 0).diagnostics), "no name"));
    EXPECT_TRUE(contains(message_of(add_object(scene, "b", arrays, 0, scaled(0.0)).diagnostics),
                         "singular"));
    EXPECT_EQ(scene.objects.size(), 1U);
}

TEST_F(Edits, PropertiesKeepTheirLimits) {
    const auto check_all = [](auto part, std::span<const PropertyInfo> infos) {
        for (const PropertyInfo& info : infos) {
            const bool is_triple =
                info.type != PropertyType::number && info.type != PropertyType::flag;
            const std::string name(info.name);
            for (const double number : {info.least, info.most}) {
                std::vector<double> numbers(is_triple ? 3 : 1, number);
                EXPECT_TRUE(set_properties(part, Values{{name, numbers}}).empty()) << name;
                const std::vector<double> got = *property_of(part, name);
                for (std::size_t i = 0; i < numbers.size(); ++i) {
                    const double wanted = info.type == PropertyType::direction
                                              ? std::copysign(std::sqrt(1.0 / 3.0), number)
                                              : numbers[i];
                    EXPECT_NEAR(got[i], wanted, 1e-7 * std::abs(wanted)) << name;
                }
            }
            const std::vector<double> before = *property_of(part, name);
            const auto beyond = [](double limit) { return 0.01 * std::max(1.0, std::abs(limit)); };
            for (const double number :
                 {info.most + beyond(info.most), info.least - beyond(info.least), nan}) {
                const std::vector<double> numbers(is_triple ? 3 : 1, number);
                EXPECT_TRUE(contains(message_of(set_properties(part, Values{{name, numbers}})),
                                     "'" + name + "' cannot be set"));
            }
            EXPECT_FALSE(set_properties(part, Values{{name, {}}}).empty());
            EXPECT_FALSE(set_properties(part, Values{{name, {0.5, 0.5}}}).empty());
            EXPECT_EQ(*property_of(part, name), before);
        }
    };
    check_all(Material(), material_properties());
    Light wide;
    wide.outer_cone = static_cast<float>(std::numbers::pi / 2.0);  // For any inner cone.
    check_all(wide, light_properties());
    Material material;
    EXPECT_TRUE(contains(
        message_of(set_properties(material, Values{{"metallic", {1.0}}, {"rougness", {0.0}}})),
        "no property 'rougness' did you mean 'roughness'?"));
    EXPECT_EQ(material.metallic, 0.0F) << "all or nothing";
    EXPECT_TRUE(set_properties(material, Values{{"base_color", {0.5}}}).empty());
    EXPECT_EQ(material.base_color, Color3f(0.5F));
}

TEST_F(Edits, OpacityDecidesHowAMaterialBlends) {
    Material material;
    EXPECT_TRUE(set_properties(material, Values{{"alpha", {1.0}}}).empty());
    EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
    EXPECT_TRUE(set_properties(material, Values{{"alpha", {0.5}}}).empty());
    EXPECT_EQ(material.alpha_mode, AlphaMode::blend);
    Material mask;
    EXPECT_TRUE(set_properties(mask, Values{{"alpha_cutoff", {0.5}}, {"alpha", {0.4}}}).empty());
    EXPECT_EQ(mask.alpha_mode, AlphaMode::mask);
}

TEST_F(Edits, TheInnerConeIsNeverWiderThanTheOuter) {
    Light light;
    EXPECT_TRUE(set_properties(light, Values{{"inner_cone", {0.6}}}).empty());
    EXPECT_TRUE(set_properties(light, Values{{"outer_cone", {0.5}}}).empty());
    EXPECT_EQ(light.inner_cone, 0.5F);
    EXPECT_TRUE(contains(message_of(set_properties(light, Values{{"inner_cone", {0.7}}})),
                         "more than the outer_cone"));
}

TEST_F(Edits, MaterialsThatNothingHasAreReplaced) {
    Scene scene = tetrahedron();
    EXPECT_TRUE(contains(message_of(add_material(scene, "clay", {}).diagnostics), "already"));
    EXPECT_EQ(*add_material(scene, "gold", Values{{"metallic", {1.0}}}), 1U);
    EXPECT_EQ(*add_material(scene, "gold", Values{{"roughness", {0.5}}}), 1U);
    EXPECT_EQ(scene.materials.size(), 2U);
    EXPECT_EQ(scene.materials[1].metallic, 0.0F);
    EXPECT_FALSE(add_material(scene, "", {}));
    EXPECT_FALSE(add_material(scene, "lead", Values{{"metallic", {2.0}}}));
}

TEST_F(Edits, ASceneIsLitWhileItHasALight) {
    Scene scene = tetrahedron();
    EXPECT_TRUE(scene.default_light);
    EXPECT_EQ(*add_light(scene, "lamp", LightKind::point, Values{{"intensity", {7.0}}}), 0U);
    EXPECT_EQ(scene.lights[0].intensity, Color3f(7.0F));
    EXPECT_FALSE(scene.default_light);
    EXPECT_TRUE(
        contains(message_of(add_light(scene, "lamp", LightKind::spot, {}).diagnostics), "already"));
    EXPECT_TRUE(set_material(scene, 0, Values{{"emission", {1, 2, 3}}}).empty());
    remove_light(scene, 0);
    EXPECT_FALSE(scene.default_light) << "the body shines";
    remove_object(scene, 0);
    EXPECT_TRUE(scene.default_light);
}

}  // namespace balcony::scene::testing::scene_edits_test
