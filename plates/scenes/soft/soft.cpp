// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/soft/soft.hpp"

#include <cmath>
#include <numbers>

#include "common/meshes.hpp"
#include "common/scene_builder.hpp"
#include "common/tubes.hpp"

namespace balcony::plates {

namespace {

using scene::Color3f;
using scene::Light;
using scene::Material;
using scene::Mesh;

// Letters are bent from a round bar, about the point in their middle.
constexpr double bend = 4.0;
constexpr double bar = 1.5;
constexpr double middle_height = 2.0 * bend + bar;
constexpr int bend_steps = 48;  // Of half a circle.

Mesh straight(const V3d& from, const V3d& to) { return tube({from, to}, bar, TubeEnds::round); }

// Three quarters of a circle above, three quarters below, which meet in the middle.
Mesh letter_s() {
    constexpr double pi = std::numbers::pi;
    constexpr int steps = bend_steps * 3 / 2;
    std::vector<V3d> path = arc(V3d(0, 0, bend), bend, 0.0, 1.5 * pi, steps);
    const std::vector<V3d> below = arc(V3d(0, 0, -bend), bend, 0.5 * pi, -pi, steps);
    path.insert(path.end(), below.begin() + 1, below.end());
    return tube(path, bar, TubeEnds::round);
}

Mesh letter_o() {
    constexpr double pi = std::numbers::pi;
    std::vector<V3d> path = arc(V3d(0, 0, bend), bend, 0.0, pi, bend_steps);
    const std::vector<V3d> below = arc(V3d(0, 0, -bend), bend, pi, 2.0 * pi, bend_steps);
    path.insert(path.end(), below.begin(), below.end());
    return tube(path, bar, TubeEnds::closed);
}

Mesh letter_f() {
    Mesh mesh = straight(V3d(-bend, 0, -2 * bend), V3d(-bend, 0, 2 * bend));
    append(mesh, straight(V3d(-bend, 0, 0), V3d(1.5, 0, 0)));
    append(mesh, straight(V3d(-bend, 0, 2 * bend), V3d(bend, 0, 2 * bend)));
    return mesh;
}

Mesh letter_t() {
    Mesh mesh = straight(V3d(0, 0, -2 * bend), V3d(0, 0, 2 * bend));
    append(mesh, straight(V3d(-bend, 0, 2 * bend), V3d(bend, 0, 2 * bend)));
    return mesh;
}

// The studio is a bowl: a floor that rises to a wall without an edge, and closes to a dome.
constexpr double floor_radius = 90.0;
constexpr double cove = 50.0;
constexpr double dome = 140.0;

Mesh bowl() {
    constexpr double pi = std::numbers::pi;
    std::vector<V3d> profile;
    for (int i = 0; i < 8; ++i) {
        profile.emplace_back(floor_radius * i / 8.0, 0.0, 0.0);
    }
    for (const V3d& p : arc(V3d(floor_radius, 0, cove), cove, -0.5 * pi, 0.0, 24)) {
        profile.push_back(p);
    }
    const std::vector<V3d> above = arc(V3d(0, 0, cove), dome, 0.0, 0.5 * pi, 32);
    profile.insert(profile.end(), above.begin() + 1, above.end());
    return lathe(profile, 96);
}

// Warm paper on the floor, which fades into the dark on its way up.
Color bowl_color(const Sample& sample) {
    static const Gradient rise({0xd2a46c, 0xd2a46c, 0xc4935f, 0x8a7a70, 0x555a60, 0x3b3f47,
                                0x33363f, 0x30333c, 0x2e313a, 0x2c2f38});
    return rise(0.5 * (sample.point.y + 1.0) * 1.4);
}

// The light of a lamp, from its middle to its edge.
Color lamp_glow(const Sample& sample) {
    const double r = 0.5 * (1.0 + sample.point.y);
    return Color(0.25 + 0.75 * std::pow(std::max(0.0, 1.0 - r * r), 1.0));
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
        builder.mesh(name, lathe({V3d(0.0), V3d(0.5 * radius, 0, 0), V3d(radius, 0, 0)}, 48),
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
                      M44d().setTranslation(V3d(x, 0, middle_height)));
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
             Color3f(0.50F, 0.75F, 1.0F) * 12.0F);
    add_glow(builder, "warm glow", 1.2, Color3f(1.0F, 0.55F, 0.14F) * 900e3F);
    add_glow(builder, "cool glow", -1.2, Color3f(0.12F, 0.5F, 1.0F) * 700e3F);
    return std::move(builder).finish();
}

}  // namespace balcony::plates
