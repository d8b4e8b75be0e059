// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Rays and scenes at and beyond the range in which Embree traces.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "balcony/probe.hpp"
#include "render/embree/accelerator.hpp"
#include "support.hpp"

namespace balcony::render::test::range_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class Opaque final : public embree::TransmittanceSource {
public:
    [[nodiscard]] Color3f transmittance(const embree::Hit&, const embree::Ray&) const override {
        return Color3f(0.0F);
    }
};

V3f along_x(float value) { return {value, 0.0F, 0.0F}; }

TEST(Range, RaysBeyondItHitNothing) {
    scene::Scene scene;
    add(scene, wall(0.0F, 1.0F), white());
    const auto accelerator = embree::Accelerator::build(scene);
    ASSERT_TRUE(accelerator);
    const V3f down(0.0F, 0.0F, -1.0F);
    const float far = 2.0F * embree::max_coordinate;
    std::vector<embree::Ray> rays{{{0.1F, 0.2F, 1.0F}, down}};
    for (const float value : {far, -far, static_cast<float>(infinity), static_cast<float>(nan)}) {
        rays.push_back({along_x(value), down});
        rays.push_back({{0.0F, 0.0F, value}, down});
        rays.push_back({{0.1F, 0.2F, 1.0F}, along_x(value)});
    }
    rays.push_back({{0.1F, 0.2F, 1.0F}, down, static_cast<float>(nan)});
    rays.push_back({{0.1F, 0.2F, 1.0F}, down, -1.0F});
    embree::Packet packet;
    ASSERT_LE(rays.size(), embree::Packet::size);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        packet.set(i, rays[i]);
    }
    accelerator->intersect(std::span(&packet, 1));
    std::vector<Color3f> transmittances(rays.size());
    accelerator->transmittance(rays, Opaque(), transmittances);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(packet.hit(i).any(), i == 0) << i;
        EXPECT_EQ(accelerator->intersect(rays[i]).any(), i == 0) << i;
        const Color3f passed(i == 0 ? 0.0F : 1.0F);
        EXPECT_EQ(accelerator->transmittance(rays[i], Opaque()), passed) << i;
        EXPECT_EQ(transmittances[i], passed) << i;
    }
    EXPECT_FALSE(
        accelerator->intersect({{0.0F, 0.0F, embree::max_coordinate}, along_x(1.0F)}).any());
}

// One that ends just in reach is traced, one beyond it is no ray at all.
TEST(Range, CameraRaysBeyondItAreNoRays) {
    scene::Scene scene;
    add(scene, wall(0.0F, 1e17F), white());
    for (const double distance : {1e18, 1.9e18, 1e30, 1e300}) {
        View view = view_down_z(0.0, 0.0, distance);
        view.right *= 1e10;
        view.up *= 1e10;
        const Rendered made = render(scene, orthographic(view), request(4, 4, "direct"));
        EXPECT_EQ(made.summary.invalid_pixels, distance < embree::max_coordinate ? 0U : 16U);
        EXPECT_EQ(made.film.pixel(1, 1).a, distance < embree::max_coordinate ? 1.0F : 0.0F);
    }
}

// A unit wall at the origin, seen by a camera near to it, beside an object at its mercy.
struct Placed {
    Result<Renderer> renderer;
    Rendered made;
};

Rendered seen_with(const scene::Scene& scene, std::size_t warnings) {
    const Result<Renderer> renderer = Renderer::make(std::make_shared<scene::Scene>(scene));
    EXPECT_TRUE(renderer);
    EXPECT_EQ(renderer.diagnostics.size(), warnings) << to_text(renderer.diagnostics);
    EXPECT_FALSE(has_errors(renderer.diagnostics));
    for (const Diagnostic& diagnostic : renderer.diagnostics) {
        EXPECT_NE(diagnostic.message.find("object 1"), std::string::npos) << diagnostic.message;
    }
    const Request asked = request(8, 8, "direct", 2);
    Film film = *make_film(asked.layout);
    const auto summary =
        render::render(*renderer, pinhole(view_down_z(0.0, 0.0, 1.0)), asked, film);
    EXPECT_TRUE(summary) << to_text(summary.diagnostics);
    return {std::move(film), *summary};
}

scene::Scene unit_wall() {
    scene::Scene scene;
    add(scene, wall(0.0F, 4.0F), white());
    return scene;
}

TEST(Range, ObjectsBeyondItAreLeftOutByName) {
    for (const float value : {3e18F, static_cast<float>(infinity), static_cast<float>(nan)}) {
        scene::Scene scene = unit_wall();
        scene::Mesh mesh = wall(-1.0F, 1.0F);
        mesh.positions[2].x = value;
        add(scene, mesh, white());
        const Rendered made = seen_with(scene, 1);
        EXPECT_EQ(made.film.layers->object[27], 1U);
    }
}

TEST(Range, PlacementsThatAreNotAffineLeaveOutTheirObject) {
    std::vector<scene::M44d> matrices;
    for (const double value : {1e19, 1e300, infinity, nan}) {
        matrices.emplace_back().translate(V3d(0.0, value, 0.0));
        matrices.emplace_back()[1][1] = value;
    }
    matrices.emplace_back()[3][3] = 0.0;
    matrices.emplace_back()[0][3] = 1.0;
    for (const scene::M44d& matrix : matrices) {
        scene::Scene scene = unit_wall();
        add(scene, wall(-1.0F, 1.0F), white(), matrix);
        EXPECT_EQ(seen_with(scene, 1).film.layers->object[27], 1U);
    }
}

// Shared meshes, placed by matrices that Embree cannot invert in floats: each is shown where it is
// and what it is, or too small to see, but neither lost nor fatal.
TEST(Range, PlacementsOfAnyScaleCanBeTraced) {
    for (const double scale : {1e-300, 1e-40, 1e-15, 1e-7, 1e-3, 1e7, 1e15}) {
        for (const bool flat : {false, true}) {
            scene::Scene scene = unit_wall();
            scene::M44d matrix;
            matrix[0][0] = matrix[1][1] = flat ? 1.0 : scale;
            matrix[2][2] = scale;
            matrix[3][2] = 0.5;
            const std::uint32_t id = add(scene, wall(0.0F, 1.0F), white(), matrix);
            scene::Instance second = scene.instances.back();
            second.world_from_mesh[3][2] = -3.0;
            scene.instances.push_back(second);
            const Rendered made = seen_with(scene, 0);
            EXPECT_EQ(made.summary.repaired, 0U);
            if (flat || scale > 1.0) {
                EXPECT_EQ(made.film.layers->object[27], id) << scale;
                EXPECT_NEAR(made.film.layers->position[27].z, 0.5F, 1e-5F) << scale;
            }
        }
    }
}

// The reach of rays ends where they would leave the range inside a placed mesh.
TEST(Range, ShrunkenInstancesShortenTheReach) {
    scene::Scene scene;
    scene::M44d shrunk;
    shrunk.setScale(1e-3);
    add(scene, wall(0.0F, 1000.0F), white(), shrunk);
    scene.instances.push_back(scene.instances.back());
    const auto accelerator = embree::Accelerator::build(scene);
    ASSERT_TRUE(accelerator);
    EXPECT_NEAR(accelerator->reach() / (1e-3F * embree::max_coordinate), 0.95F, 0.06F);
    const V3f down(0.0F, 0.0F, -1.0F);
    EXPECT_TRUE(accelerator->intersect({{0.1F, 0.2F, 1.0F}, down}).any());
    EXPECT_FALSE(accelerator->intersect({{0.1F, 0.2F, 1.01F * accelerator->reach()}, down}).any());
}

TEST(Range, LightsOfAnyPlaceAndStrengthAreSafe) {
    for (const double value : {1e20, 1e39, 1e160, 1e308, infinity, nan}) {
        scene::Scene scene = unit_wall();
        scene::Light lamp;
        lamp.position = V3d(0.0, 0.0, value);
        scene.lights.push_back(lamp);
        lamp.position = V3d(0.0, 0.0, 1.0);
        lamp.direction = V3d(value, 0.0, 0.0);
        lamp.kind = scene::LightKind::spot;
        scene.lights.push_back(lamp);
        lamp.kind = scene::LightKind::directional;
        scene.lights.push_back(lamp);
        lamp.intensity = Color3f(static_cast<float>(infinity));
        scene.lights.push_back(lamp);
        const Color4f pixel = seen_with(scene, 0).film.pixel(3, 3);
        EXPECT_TRUE(std::isfinite(pixel.r)) << value;
    }
}

// Between two mirrors at the end of the range, where a reflected ray starts beyond it.
TEST(Range, SecondaryRaysBeyondItEnd) {
    scene::Scene scene;
    scene::Material mirror = white();
    mirror.metallic = 1.0F;
    mirror.roughness = 0.0F;
    const float far = 0.99F * embree::max_coordinate;
    add(scene, wall(-far, far), mirror);
    add(scene, wall(far, far), mirror);
    scene::Material glass = white();
    glass.alpha_mode = scene::AlphaMode::blend;
    glass.alpha = 0.5F;
    add(scene, wall(-0.5F * far, far), glass);
    const Rendered made =
        render(scene, pinhole(view_down_z(0.0, 0.0, 0.0)), request(16, 16, "direct", 2));
    EXPECT_EQ(made.summary.invalid_pixels, 0U);
}

TEST(Range, ScenesWhoseIndicesLeadNowhereAreErrors) {
    const auto refused = [](void (*change)(scene::Scene&)) {
        scene::Scene scene = unit_wall();
        change(scene);
        const auto renderer = Renderer::make(std::make_shared<scene::Scene>(scene));
        return !renderer && has_errors(renderer.diagnostics);
    };
    EXPECT_FALSE(refused([](scene::Scene&) {}));
    EXPECT_TRUE(refused([](scene::Scene& s) { s.meshes[0].edit().triangles[1][2] = 4; }));
    EXPECT_TRUE(refused([](scene::Scene& s) { s.meshes[0].edit().normals.pop_back(); }));
    EXPECT_TRUE(
        refused([](scene::Scene& s) { s.meshes[0].edit().texture_coordinates[1].resize(1); }));
    EXPECT_TRUE(refused([](scene::Scene& s) { s.meshes[0].edit().material = {}; }));
    EXPECT_TRUE(refused([](scene::Scene& s) { s.instances[0].mesh = scene::MeshIndex(1); }));
    EXPECT_TRUE(refused([](scene::Scene& s) { s.instances[0].object = 1; }));
    EXPECT_TRUE(refused(
        [](scene::Scene& s) { s.materials[0].emission_texture.index = scene::TextureIndex(0); }));
}

TEST(Range, ProbesSeeWhatIsLeft) {
    scene::Scene scene = unit_wall();
    scene::Mesh mesh = wall(-1.0F, 1.0F);
    mesh.positions[0].y = 1e19F;
    add(scene, mesh, white());
    const auto renderer = Renderer::make(std::make_shared<const scene::Scene>(scene));
    ASSERT_TRUE(renderer);
    EXPECT_EQ(renderer.diagnostics.size(), 1U);
    const auto probed =
        probe(*renderer, pinhole(view_down_z(0.0, 0.0, 1.0)), {.width = 8, .height = 8});
    ASSERT_TRUE(probed);
    EXPECT_TRUE(probed->objects[0].seen);
    EXPECT_FALSE(probed->objects[1].seen);
}

}  // namespace
}  // namespace balcony::render::test::range_test
