// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/soft/soft.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "common/scene_builder.hpp"
#include "common/solids.hpp"
#include "scenes/soft/letters.hpp"

namespace balcony::plates {

namespace {

using scene::Color3f;
using scene::Light;
using scene::Material;
using scene::Mesh;

// The studio is a bowl: a floor that rises to a wall without an edge, and closes to a dome.
constexpr double floor_radius = 90.0;
constexpr double cove = 50.0;
constexpr double dome = 140.0;

Mesh bowl() {
    constexpr double right_angle = 0.5 * std::numbers::pi;
    constexpr int steps = 32;
    std::vector<V2d> profile{{0.0, 0.0}};
    const auto add_quarter = [&](const V2d& center, double radius, double from) {
        for (int i = 0; i <= steps; ++i) {
            const double angle = from + right_angle * i / steps;
            profile.push_back(center + radius * V2d(std::cos(angle), std::sin(angle)));
        }
    };
    add_quarter(V2d(floor_radius, cove), cove, -right_angle);
    profile.pop_back();
    add_quarter(V2d(0.0, cove), dome, 0.0);
    profile.back().x = 0.0;
    return lathe(profile, 96);
}

// Warm paper on the floor, which fades into the dark on its way up.
Color bowl_color(const Sample& sample) {
    static const Gradient rise({0xd2a46c, 0xd2a46c, 0xc4935f, 0x8a7668, 0x4c525c, 0x2b3442,
                                0x212b3a, 0x1e2837, 0x1c2634, 0x1b2431});
    return rise(0.5 * (sample.point.y + 1.0) * 1.4);
}

// The light of a lamp, from its edge to its middle.
Color lamp_glow(const Sample& sample) {
    const double r = 0.5 * (1.0 - sample.point.y);
    return Color(1.0 - 0.75 * r * r);
}

// A disc that shines from one place towards another.
void add_lamp(SceneBuilder& builder, const char* name, const V3d& from, const V3d& towards,
              double radius, const Color3f& radiance) {
    Material shining;
    shining.name = name;
    shining.base_color = Color3f(0.0F);
    shining.emission = radiance;
    shining.double_sided = false;
    shining.emission_texture.index = builder.texture(name, 4, 64, lamp_glow, scene::Wrap::clamp);
    const scene::MeshIndex disc =
        builder.mesh(name, lathe(std::array{V2d(radius, 0), V2d(0.5 * radius, 0), V2d(0, 0)}, 48),
                     builder.material(shining));
    const V3d z = (towards - from).normalized();
    const V3d x = V3d(0, 0, 1).cross(z).normalized();
    const V3d y = z.cross(x).normalized();
    builder.place(
        name, disc,
        M44d(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, from.x, from.y, from.z, 1));
}

// A spot of light on the dome, as seen from the middle of the O: forward for each unit upward.
void add_glow(SceneBuilder& builder, const char* name, double forward, const Color3f& intensity) {
    Light light;
    light.name = name;
    light.kind = scene::LightKind::spot;
    light.position = V3d(-7, 0, 30);
    light.direction = V3d(0, forward, 1).normalized();
    light.intensity = intensity;
    light.inner_cone = 0.0F;
    light.outer_cone = 0.2F;
    builder.light(light);
}

}  // namespace

Result<scene::Scene> make_soft(const SceneOptions& options) {
    SceneBuilder builder("soft", options);

    Material lacquer;
    lacquer.name = "red lacquer";
    lacquer.base_color = tint(0xc4141c);
    lacquer.roughness = 0.45F;
    lacquer.clearcoat = 1.0F;
    lacquer.clearcoat_roughness = 0.14F;
    const scene::MaterialIndex red = builder.material(lacquer);
    const auto letter = [&](const char* name, Mesh mesh, double x) {
        builder.place(name, builder.mesh(name, std::move(mesh), red),
                      M44d().setTranslation(V3d(x, 0, letter_middle)));
    };
    letter("letter S", letter_s(), -20.0);
    letter("letter O", letter_o(), -7.0);
    letter("letter F", letter_f(), 7.0);
    letter("letter T", letter_t(), 20.0);

    const scene::TextureIndex paint =
        builder.texture("bowl", 8, 512, bowl_color, scene::Wrap::clamp);
    builder.place("studio", builder.mesh("studio", bowl(),
                                         builder.material("studio", Color3f(1.0F), 0.6F, paint)));

    add_lamp(builder, "key light", V3d(10, 130, 62), V3d(0, 0, 8), 17.0,
             Color3f(1.0F, 0.80F, 0.58F) * 70.0F);
    add_lamp(builder, "fill light", V3d(-40, -122, 44), V3d(0, 0, 8), 22.0,
             Color3f(0.55F, 0.77F, 1.0F) * 17.0F);
    add_glow(builder, "warm glow", 1.2, Color3f(1.0F, 0.50F, 0.12F) * 2400e3F);
    add_glow(builder, "cool glow", -1.2, Color3f(0.10F, 0.5F, 1.0F) * 1000e3F);
    return std::move(builder).finish();
}

}  // namespace balcony::plates
