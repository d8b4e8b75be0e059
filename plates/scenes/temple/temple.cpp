// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/temple/temple.hpp"

#include <fmt/format.h>

#include "common/scene_builder.hpp"
#include "scenes/temple/arcade.hpp"
#include "scenes/temple/column.hpp"
#include "scenes/temple/desert.hpp"
#include "scenes/temple/dimensions.hpp"
#include "scenes/temple/marble.hpp"

namespace balcony::plates {

namespace {

using scene::Material;
using scene::MaterialIndex;
using scene::TextureEncoding;
using scene::TextureIndex;
using scene::Wrap;

void add_temple(SceneBuilder& builder) {
    const TextureIndex veins = builder.texture("marble", 1024, 1024, temple::marble, Wrap::repeat,
                                               TextureEncoding::srgb, Sampling::centre);
    const MaterialIndex marble = builder.material("marble", scene::Color3f(1.0F), 0.42F, veins);
    const MaterialIndex worn =
        builder.material("worn marble", scene::Color3f(0.93F, 0.9F, 0.85F), 0.6F, veins);
    const TextureIndex slabs =
        builder.texture("floor", 1536, 1536, temple::floor_slabs, Wrap::clamp);
    const MaterialIndex polished =
        builder.material("polished marble", scene::Color3f(1.0F), 0.3F, slabs);

    for (int k = 1; k <= temple::column_count; ++k) {
        const std::string name = fmt::format("column {}", k);
        const M44d placed = M44d().setTranslation(V3d(temple::radius, 0, 0)) *
                            M44d().setAxisAngle(V3d(0, 0, 1), (k - 1) * temple::bay);
        builder.place(name, builder.mesh(name, temple::column(k), marble), placed);
    }
    for (int k = 1; k <= temple::column_count; ++k) {
        const std::string name = fmt::format("arch {}", k);
        builder.place(name, builder.mesh(name, temple::arch(k), marble));
    }
    builder.place("ring", builder.mesh("ring", temple::ring(), marble));
    builder.place("steps", builder.mesh("steps", temple::steps(), worn));
    builder.place("floor", builder.mesh("floor", temple::floor_disc(), polished));
}

// Pieces of a column, half buried: where, how deep, and how they lie.
void add_ruins(SceneBuilder& builder) {
    const TextureIndex veins = builder.texture("old marble", 512, 512, temple::marble, Wrap::repeat,
                                               TextureEncoding::srgb, Sampling::centre);
    const MaterialIndex stone =
        builder.material("old marble", scene::Color3f(0.9F, 0.84F, 0.75F), 0.7F, veins);
    const auto lay = [&](const char* name, scene::Mesh mesh, const V3d& at, double turn,
                         double tilt) {
        builder.place(name, builder.mesh(name, std::move(mesh), stone),
                      M44d().setAxisAngle(V3d(0, 1, 0), tilt) *
                          M44d().setAxisAngle(V3d(0, 0, 1), turn) * M44d().setTranslation(at));
    };
    lay("fallen drum 1", temple::fallen_drum(21, 1.7), V3d(-18.2, 10.2, 0.3), 1.0, 1.55);
    lay("fallen drum 2", temple::fallen_drum(22, 1.2), V3d(-17.6, 13.6, 0.1), 1.9, 1.42);
    lay("fallen capital", temple::capital(), V3d(-16.0, -2.2, 0.2), 0.4, 0.85);
}

void add_desert(SceneBuilder& builder) {
    Material sand;
    sand.name = "sand";
    sand.base_color = scene::Color3f(1.0F);
    sand.roughness = 0.95F;
    sand.specular = 0.4F;
    sand.normal_texture.index =
        builder.texture("ripples", 1024, 1024, temple::sand_ripples, Wrap::repeat,
                        TextureEncoding::linear, Sampling::centre);
    builder.place("sand", builder.mesh("sand", temple::sand(), builder.material(sand)));

    // It shows its picture as it is. Paths find its light by themselves, as it is nearly even.
    Material sky;
    sky.name = "sky";
    sky.base_color = scene::Color3f(1.0F);
    sky.unlit = true;
    sky.base_color_texture.index =
        builder.texture("sky", 2048, 512, temple::sky_picture, Wrap::repeat, TextureEncoding::srgb,
                        Sampling::centre);
    builder.place("sky", builder.mesh("sky", temple::sky_dome(), builder.material(sky)));

    Material sun;
    sun.name = "sun";
    sun.base_color = scene::Color3f(1.0F);
    sun.emission = scene::Color3f(1.0F, 0.72F, 0.43F) * 9.5e4F;
    builder.place("sun", builder.mesh("sun", temple::sun_disc(), builder.material(sun)));
}

}  // namespace

Result<scene::Scene> make_temple(const SceneOptions& options) {
    SceneBuilder builder("temple", options);
    add_temple(builder);
    add_ruins(builder);
    add_desert(builder);
    return std::move(builder).finish();
}

}  // namespace balcony::plates
