// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/dancer/dancer.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "common/meshes.hpp"
#include "common/scene_builder.hpp"
#include "common/solids.hpp"
#include "scenes/dancer/figure.hpp"

namespace balcony::plates {

namespace {

using scene::Color3f;
using scene::Light;
using scene::Material;

// Lower discs than the dancer's, on which she stands: a plinth of dark stone with a rounded edge.
void add_plinth(SceneBuilder& builder) {
    Material stone;
    stone.name = "polished stone";
    stone.base_color = tint(0x17181b);
    stone.roughness = 0.25F;
    const std::vector<V2d> profile{{0.62, -0.30},  {0.62, -0.035}, {0.612, -0.012},
                                   {0.60, -0.003}, {0.585, 0.0},   {0.0, 0.0}};
    builder.place("plinth", builder.mesh("plinth", lathe(profile, 128), builder.material(stone)));
}

// A panel that shines towards the dancer.
void add_panel(SceneBuilder& builder, const char* name, const V3d& from, const V3d& towards,
               double width, double height, const Color3f& radiance) {
    Material shining;
    shining.name = name;
    shining.base_color = Color3f(0.0F);
    shining.emission = radiance;
    shining.double_sided = false;
    const V3d z = (towards - from).normalized();
    const V3d x = V3d(0, 0, 1).cross(z).normalized();
    const V3d y = z.cross(x);
    builder.place(
        name, builder.mesh(name, rectangle(width, height), builder.material(shining)),
        M44d(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, from.x, from.y, from.z, 1));
}

// The golden edge of a veil, in short pieces: the smaller a mesh, the finer the steps in which its
// movement is traced, and the rounder the line that it draws in the picture.
void add_edge(SceneBuilder& builder, const std::string& name, const std::vector<V3d>& path,
              scene::NodeIndex table, scene::MaterialIndex material) {
    constexpr std::size_t points = 12;
    int number = 0;
    for (std::size_t first = 0; first + 1 < path.size(); first += points) {
        const std::size_t count = std::min(points + 1, path.size() - first);
        const std::string piece = fmt::format("{} {}", name, ++number);
        const scene::Mesh mesh = tube(std::span(path).subspan(first, count), dancer_edge_radius);
        builder.place_on(table, piece, builder.mesh(piece, mesh, material));
    }
}

}  // namespace

Result<scene::Scene> make_dancer(const SceneOptions& options) {
    SceneBuilder builder("dancer", options);

    Material porcelain;
    porcelain.name = "porcelain";
    porcelain.base_color = tint(0xe9e2d6);
    porcelain.roughness = 0.42F;
    const bool fine = options.texture_scale > 0.5;
    const scene::MeshIndex figure =
        builder.mesh("dancer", dancer_figure(fine ? 0.008 : 0.03), builder.material(porcelain));
    Material gold;
    gold.name = "gold";
    gold.base_color = Color3f(1.0F, 0.71F, 0.29F);
    gold.metallic = 1.0F;
    gold.roughness = 0.3F;
    const scene::MaterialIndex golden = builder.material(gold);
    Material silk;
    silk.name = "silk";
    silk.base_color = tint(0xe9e2d6);
    silk.roughness = 0.55F;
    const scene::MaterialIndex veil = builder.material(silk);
    const scene::NodeIndex table = builder.turntable(V3d(0.0), 1.0, 2, dancer_start);
    builder.place_on(table, "dancer", figure);
    for (const double side : {-1.0, 1.0}) {
        const std::string end = side < 0.0 ? " left" : " right";
        builder.place_on(table, "veil" + end, builder.mesh("veil" + end, dancer_veil(side), veil));
        add_edge(builder, "edge" + end, dancer_veil_edge(side), table, golden);
    }
    add_plinth(builder);

    const scene::MaterialIndex wall = builder.material("wall", tint(0x323d45), 0.9F);
    const M44d upright(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 2.6, 2.0, 1);
    builder.place("wall", builder.mesh("wall", rectangle(14, 8), wall), upright);

    Light glow;
    glow.name = "glow";
    glow.kind = scene::LightKind::spot;
    glow.position = V3d(0, 0.6, 0.2);
    glow.direction = V3d(0, 1, 0.55).normalized();
    glow.intensity = Color3f(0.45F, 0.75F, 0.85F) * 16.0F;
    glow.outer_cone = 0.95F;
    builder.light(glow);

    add_panel(builder, "key light", V3d(-2.6, -2.2, 2.9), V3d(0, 0, 1.1), 1.4, 2.2,
              Color3f(1.0F, 0.86F, 0.70F) * 9.0F);
    add_panel(builder, "rim light", V3d(2.4, 1.4, 2.0), V3d(0, 0, 1.1), 0.7, 2.4,
              Color3f(0.55F, 0.78F, 1.0F) * 9.0F);
    return std::move(builder).finish();
}

}  // namespace balcony::plates
