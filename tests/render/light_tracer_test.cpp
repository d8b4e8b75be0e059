// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The preview has a faster way for films without data layers, which must show the same.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "shading/surfaces/surface_lanes.hpp"
#include "support.hpp"

namespace balcony::render::light_tracer_test {

namespace {

using namespace test;
using Imath::V3f;

// A ball of few triangles, whose normals of the smooth surface are far from those of the triangles,
// also behind its horizon.
scene::Mesh coarse_ball(bool with_normals) {
    using std::numbers::pi;
    constexpr std::uint32_t rings = 5;
    constexpr std::uint32_t segments = 6;
    scene::Mesh mesh;
    for (std::uint32_t i = 0; i <= rings; ++i) {
        for (std::uint32_t j = 0; j <= segments; ++j) {
            const double polar = pi * i / rings;
            const double turn = 2.0 * pi * j / segments;
            mesh.positions.emplace_back(V3d(std::sin(polar) * std::cos(turn),
                                            std::sin(polar) * std::sin(turn), std::cos(polar)));
            if (with_normals) {
                mesh.normals.push_back(mesh.positions.back());
            }
        }
    }
    constexpr std::uint32_t row = segments + 1;
    for (std::uint32_t i = 0; i < rings; ++i) {
        for (std::uint32_t j = 0; j < segments; ++j) {
            const std::uint32_t corner = i * row + j;
            mesh.triangles.push_back({corner, corner + row, corner + 1});
            mesh.triangles.push_back({corner + 1, corner + row, corner + row + 1});
        }
    }
    return mesh;
}

scene::M44d placed(const V3d& scale, const V3d& at) {
    scene::M44d matrix;
    matrix.setScale(scale);
    matrix.rotate(V3d(0.3, 0.2, 0.5));
    matrix[3][0] = at.x;
    matrix[3][1] = at.y;
    matrix[3][2] = at.z;
    return matrix;
}

// Smooth and flat balls; stretched, mirrored and shared ones, which are placed by matrices; a
// translucent one, one that shines, and walls with textures.
scene::Scene balls() {
    scene::Scene scene;
    scene::Material colored = white();
    colored.base_color = {0.8F, 0.5F, 0.2F};
    add(scene, coarse_ball(true), colored, placed(V3d(0.3), {-0.6, -0.6, 0.0}));
    add(scene, coarse_ball(false), colored, placed(V3d(0.3), {0.0, -0.6, 0.0}));
    add(scene, coarse_ball(true), colored, placed({0.3, -0.2, 0.4}, {0.6, -0.6, 0.0}));
    for (const bool with_normals : {false, true}) {
        const double y = with_normals ? 0.6 : 0.0;
        add(scene, coarse_ball(with_normals), white(), placed({0.1, 0.3, -0.2}, {-0.6, y, 0.0}));
        scene::Instance second = scene.instances.back();
        second.world_from_mesh = placed({0.3, 0.1, 0.1}, {0.0, y, 0.0});
        scene.instances.push_back(second);
    }
    scene::Material translucent = colored;
    translucent.alpha = 0.5F;
    translucent.alpha_mode = scene::AlphaMode::blend;
    add(scene, coarse_ball(true), translucent, placed(V3d(0.3), {0.6, 0.0, 0.0}));
    scene::Material shining = colored;
    shining.emission = {0.1F, 2.0F, 0.3F};
    shining.base_color_texture.index =
        add_texture(scene, encode_png(16, 16, 3, [](int x, int y) {
                        return std::vector<std::uint8_t>{static_cast<std::uint8_t>(16 * x), 99,
                                                         static_cast<std::uint8_t>(16 * y)};
                    }));
    add(scene, wall(-0.5F, 0.9F), shining);
    scene::Mesh tilted =
        parallelogram({-2.0F, 1.0F, -0.9F}, {4.0F, 0.5F, -0.3F}, {0.1F, 1.0F, -3.0F});
    add(scene, tilted, shining);
    // The image is emitted, too.
    shining.emission_texture = shining.base_color_texture;
    add(scene, wall(-0.4F, 0.2F), shining);
    shining.emission_texture = {};
    shining.base_color_texture = {};
    add(scene, coarse_ball(true), shining, placed(V3d(0.3), {0.6, 0.6, 0.0}));
    return scene;
}

// The shading multiplies and adds some ten floats, each rounded to 6e-8; the light is at most 2.8.
constexpr float rounding = 5e-6F;

TEST(LightTracer, ShowsWhatTheIntegratorShows) {
    const scene::Scene scene = balls();
    const camera::Camera camera = pinhole(view_down_z(0.0, 0.0, 1.6));
    Request with_layers = request(131, 77, "preview", 2);
    Request without_layers = with_layers;
    without_layers.layout.data_layers = false;
    const Film slow = render(scene, camera, with_layers).film;
    const Film fast = render(scene, camera, without_layers).film;
    ASSERT_TRUE(slow.layers && !fast.layers);
    std::size_t covered = 0;
    for (std::size_t y = 0; y < slow.height; ++y) {
        for (std::size_t x = 0; x < slow.width; ++x) {
            const Color4f expected = slow.light(x, y);
            const Color4f found = fast.light(x, y);
            for (int channel = 0; channel < 4; ++channel) {
                ASSERT_NEAR(found[channel], expected[channel], rounding)
                    << "at " << x << ", " << y << ", channel " << channel;
            }
            covered += expected.a > 0.0F ? 1 : 0;
        }
    }
    EXPECT_GT(covered, slow.width * slow.height / 4);
}

TEST(LightTracer, RaysThatDoNotExistAreBlackAndCounted) {
    const scene::Scene scene = balls();
    const V3d forward(0.0, 0.0, -1.0);
    const camera::Camera camera = make_camera(
        {[](const camera::ParameterPoint& p, camera::Emitter& emit) {
             emit.require(p.u < emit(0.25));
             return camera::ObjectPoint{p.u, p.v, emit(3.0)};
         },
         [&](const camera::ParameterPoint&, camera::Emitter& emit) {
             return camera::ObjectVector{emit(forward.x), emit(forward.y), emit(forward.z)};
         }});
    Request asked = request(70, 35, "preview");
    asked.layout.data_layers = false;
    const Rendered picture = render(scene, camera, asked);
    std::size_t missing = 0;
    for (std::size_t y = 0; y < asked.layout.height; ++y) {
        for (std::size_t x = 0; x < asked.layout.width; ++x) {
            const double u = (static_cast<double>(x) + 0.5) / 35.0 - 1.0;
            if (u >= 0.25) {
                ++missing;
                EXPECT_EQ(picture.film.light(x, y).a, 0.0F);
            }
        }
    }
    EXPECT_EQ(picture.summary.invalid_rays, missing);
    EXPECT_EQ(picture.summary.camera_rays, asked.layout.width * asked.layout.height);
}

TEST(SurfaceLanes, TheNormalOfATinyTriangleHasALength) {
    const scene::Mesh mesh;
    surface_lanes::Look look;
    look.is_plain = true;
    look.base_color = {1.0F, 1.0F, 1.0F};
    look.mesh.mesh = &mesh;
    embree::Packet packet;
    for (std::size_t lane = 0; lane < embree::Packet::size; ++lane) {
        packet.geometry[lane] = 0;
        packet.placement[lane] = embree::Hit::nothing;
        packet.direction_x[lane] = 0.6F;
        packet.direction_z[lane] = -0.8F;
        packet.normal_z[lane] = std::ldexp(1.0F, 120 - 17 * static_cast<int>(lane));
    }
    surface_lanes::Lit lit{};
    surface_lanes::Radiances radiances{};
    surface_lanes::light(packet, std::span(&look, 1), lit, radiances);
    for (const float cosine : radiances.color.x) {
        EXPECT_NEAR(cosine, 0.8F, 1e-6F);
    }
}

}  // namespace

}  // namespace balcony::render::light_tracer_test
