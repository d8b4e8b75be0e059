// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "common/mesh_builder.hpp"
#include "scenes/print_gallery/parts.hpp"

namespace balcony::plates::print_gallery {

namespace {

using scene::MaterialIndex;

MaterialIndex cloth(SceneBuilder& builder, const char* name, std::uint32_t color, float roughness) {
    scene::Material material;
    material.name = name;
    material.base_color = tint(color);
    material.roughness = roughness;
    material.specular = 0.3F;
    material.sheen_color = tint(0x555a66);
    material.sheen_roughness = 0.5F;
    return builder.material(std::move(material));
}

// Facing x. A body of revolution is as wide as this along y, and narrower along x.
const M44d flattened = M44d().setScale(V3d(0.68, 1.0, 1.0));

MeshBuilder overcoat() {
    MeshBuilder coat;
    const MeshBuilder body = MeshBuilder().lathe(V3d(0.0),
                                                 {{0.0, 0.33},
                                                  {0.235, 0.33},
                                                  {0.235, 0.33},
                                                  {0.225, 0.55},
                                                  {0.205, 0.85},
                                                  {0.195, 1.02},
                                                  {0.212, 1.2},
                                                  {0.222, 1.34},
                                                  {0.205, 1.42},
                                                  {0.15, 1.475},
                                                  {0.075, 1.505},
                                                  {0.0, 1.51}},
                                                 48);
    coat.add(body, flattened);
    // The collar, turned up a little, and the arms with the hands in the pockets.
    coat.add(
        MeshBuilder().lathe(
            V3d(0.0, 0.0, 1.475),
            {{0.105, 0.0}, {0.112, 0.03}, {0.09, 0.075}, {0.09, 0.075}, {0.08, 0.07}, {0.075, 0.0}},
            36),
        M44d().setScale(V3d(0.9, 1.0, 1.0)));
    for (const double side : {-1.0, 1.0}) {
        coat.tube({{V3d(0.0, side * 0.165, 1.395), 0.072},
                   {V3d(-0.005, side * 0.222, 1.31), 0.073},
                   {V3d(-0.025, side * 0.262, 1.14), 0.062},
                   {V3d(-0.02, side * 0.272, 1.02), 0.057},
                   {V3d(0.03, side * 0.256, 0.88), 0.053},
                   {V3d(0.06, side * 0.232, 0.8), 0.05}},
                  20);
    }
    return coat;
}

MeshBuilder trousers_and_shoes() {
    MeshBuilder legs;
    for (const double side : {-1.0, 1.0}) {
        legs.tube({{V3d(0.0, side * 0.085, 0.45), 0.085}, {V3d(0.0, side * 0.09, 0.1), 0.07}}, 20);
        legs.ellipsoid(V3d(0.05, side * 0.095, 0.045), V3d(0.14, 0.052, 0.05));
    }
    return legs;
}

MeshBuilder head() {
    MeshBuilder skin;
    skin.tube({{V3d(-0.005, 0.0, 1.44), 0.062}, {V3d(0.005, 0.0, 1.6), 0.058}}, 24);
    skin.ellipsoid(V3d(0.012, 0.0, 1.655), V3d(0.1, 0.078, 0.118), 36);
    for (const double side : {-1.0, 1.0}) {
        skin.ellipsoid(V3d(0.0, side * 0.081, 1.648), V3d(0.02, 0.009, 0.034), 16);
    }
    skin.ellipsoid(V3d(0.112, 0.0, 1.645), V3d(0.022, 0.013, 0.028), 16);
    return skin;
}

MeshBuilder bowler_hat() {
    const MeshBuilder round = MeshBuilder().lathe(V3d(0.0),
                                                  {{0.088, 0.0},
                                                   {0.13, -0.006},
                                                   {0.152, 0.012},
                                                   {0.157, 0.024},
                                                   {0.151, 0.024},
                                                   {0.128, 0.008},
                                                   {0.099, 0.012},
                                                   {0.099, 0.012},
                                                   {0.1, 0.05},
                                                   {0.094, 0.09},
                                                   {0.075, 0.122},
                                                   {0.04, 0.14},
                                                   {0.0, 0.144}},
                                                  48);
    return MeshBuilder().add(round, M44d().setScale(V3d(1.14, 1.0, 1.0)));
}

}  // namespace

void add_visitor(SceneBuilder& builder, const M44d& placed) {
    const MaterialIndex wool = cloth(builder, "overcoat", 0x23262e, 0.9F);
    const MaterialIndex felt = cloth(builder, "felt", 0x17171a, 0.8F);
    const MaterialIndex skin = builder.material("skin", tint(0xc9987a), 0.5F);
    const MaterialIndex hair = builder.material("hair", tint(0x3a2618), 0.7F);
    const MaterialIndex linen = builder.material("linen", tint(0xf2efe8), 0.8F);
    const auto put = [&](const char* name, const MeshBuilder& solid, MaterialIndex material,
                         const M44d& turned = M44d()) {
        builder.place(name, builder.mesh(name, solid.mesh(), material), turned * placed);
    };
    put("visitor coat", overcoat(), wool);
    put("visitor legs", trousers_and_shoes(), felt);
    put("visitor head", head(), skin);
    put("visitor hair",
        MeshBuilder().ellipsoid(V3d(-0.012, 0.0, 1.668), V3d(0.094, 0.0815, 0.088), 32), hair);
    put("visitor shirt collar",
        MeshBuilder().lathe(V3d(0.0, 0.0, 1.53),
                            {{0.072, 0.0}, {0.069, 0.045}, {0.069, 0.045}, {0.063, 0.045}}),
        linen);
    // Tilted back: he looks up a little.
    put("visitor hat", bowler_hat(), felt,
        M44d().setAxisAngle(V3d(0, 1, 0), -0.09) * M44d().setTranslation(V3d(-0.006, 0.0, 1.705)));
}

}  // namespace balcony::plates::print_gallery
