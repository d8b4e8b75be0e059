// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Preparing a scene, making a job and probing tell how far they are, and can be stopped.

#include <algorithm>
#include <memory>
#include <stop_token>
#include <vector>

#include <gtest/gtest.h>

#include "balcony/motion.hpp"
#include "balcony/probe.hpp"
#include "support.hpp"

namespace balcony::render::test::stop_test {
namespace {

// Shared spheres, of which one moves, a large mesh of its own, and textures.
std::shared_ptr<const scene::Scene> large_scene() {
    scene::Scene scene;
    add(scene, coarse_sphere(0.4F, 100, 50), white());
    scene.instances.push_back(scene.instances.back());
    scene.instances.back().world_from_mesh.setTranslation(V3d(2.0, 0.0, 0.0));
    add(scene, coarse_sphere(5.0F, 600, 400), white());
    for (int i = 0; i < 8; ++i) {
        add(scene, wall(-3.0F - static_cast<float>(i), 1.0F), white());
        scene.materials.back().base_color_texture.index = add_texture(
            scene, encode_png(300, 300, 3, [i](int x, int y) {
                return std::vector<std::uint8_t>(3, static_cast<std::uint8_t>(x ^ y ^ i));
            }));
    }
    auto motion = std::make_shared<scene::Motion>();
    motion->tracks = {{scene::Interpolation::linear, 3, {0.0, 1.0}, {0, 0, 0, 0.5F, 1.0F, 0.3F}}};
    scene::Node node;
    node.translation_track = scene::TrackIndex(0);
    motion->nodes = {node};
    motion->instances = {{1, scene::NodeIndex(0)}};
    scene.motion = std::move(motion);
    return std::make_shared<const scene::Scene>(std::move(scene));
}

std::stop_token stop_beforehand() {
    std::stop_source stop;
    stop.request_stop();
    return stop.get_token();
}

template <class Value>
bool is_stopped(const Result<Value>& result) {
    return !result && kind_of_errors(result.diagnostics) == Kind::interrupted;
}

TEST(Stops, PreparingASceneTellsItsProgress) {
    std::vector<double> parts;
    const auto renderer =
        Renderer::make(large_scene(), {}, [&](double part) { parts.push_back(part); });
    ASSERT_TRUE(renderer);
    EXPECT_GE(parts.size(), 4U);
    EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end())) << ::testing::PrintToString(parts);
    EXPECT_GT(parts.back(), 0.8);
    EXPECT_LE(parts.back(), 1.0);
}

TEST(Stops, PreparingASceneObeysAtAnyTime) {
    const auto scene = large_scene();
    EXPECT_TRUE(is_stopped(Renderer::make(scene, {}, {}, stop_beforehand())));
    for (const double at : {0.0, 0.2, 0.45, 0.6, 0.9}) {
        std::stop_source stop;
        const auto renderer = Renderer::make(
            scene, {},
            [&](double part) {
                if (part >= at) {
                    stop.request_stop();
                }
            },
            stop.get_token());
        EXPECT_TRUE(is_stopped(renderer)) << at;
    }
}

// What was stopped can be done later.
TEST(Stops, ARendererMovesAfterAStop) {
    const auto scene = large_scene();
    const Result<Renderer> renderer = Renderer::make(scene);
    ASSERT_TRUE(renderer);
    const auto later = at_time(*scene, 0.5);
    std::stop_source stop;
    EXPECT_TRUE(is_stopped(renderer->moved(
        later, {0.5, 0.5}, [&](double) { stop.request_stop(); }, stop.get_token())));
    EXPECT_TRUE(renderer->moved(later, {0.5, 0.5}));
}

TEST(Stops, JobsAndProbesObey) {
    const Result<Renderer> made = Renderer::make(large_scene());
    ASSERT_TRUE(made);
    const Renderer& renderer = *made;
    const camera::Camera camera = pinhole(view_down_z(0.0, 0.0, 3.0));
    const Request asked = request(32, 32, "path");
    const auto film = std::make_shared<Film>(*make_film(asked.layout));
    const std::stop_token stop = stop_beforehand();
    EXPECT_TRUE(is_stopped(Job::make(renderer, camera, asked, film, stop)));
    EXPECT_TRUE(is_stopped(probe(renderer, camera, {}, {}, stop)));
    EXPECT_TRUE(is_stopped(explain_miss(renderer, camera, {}, stop)));
    EXPECT_TRUE(is_stopped(default_camera(renderer, stop)));
    EXPECT_TRUE(is_stopped(measure_scene(renderer, {}, stop)));
    const std::vector<SightLine> lines{{{0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}}};
    EXPECT_TRUE(is_stopped(find_obstacles(renderer, lines, Axes::y_up, stop)));
    const Result<Summary> summary = render::render(renderer, camera, asked, *film, {}, stop);
    ASSERT_TRUE(summary);
    EXPECT_TRUE(summary->interrupted);
}

TEST(Stops, AProbeTellsItsProgress) {
    const Result<Renderer> renderer = Renderer::make(large_scene());
    std::vector<double> parts;
    const auto found = probe(*renderer, pinhole(view_down_z(0.0, 0.0, 3.0)), {},
                             [&](double part) { parts.push_back(part); });
    ASSERT_TRUE(found);
    EXPECT_GE(parts.size(), 4U);
    EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
    EXPECT_EQ(parts.back(), 1.0);
}

TEST(Stops, WithoutASceneOrAFilmThereIsAnError) {
    EXPECT_EQ(kind_of_errors(Renderer::make(nullptr).diagnostics), Kind::internal);
    scene::Scene broken;
    broken.instances.push_back({.mesh = scene::MeshIndex(0), .world_from_mesh = {}});
    EXPECT_EQ(
        kind_of_errors(Renderer::make(std::make_shared<const scene::Scene>(broken)).diagnostics),
        Kind::internal);
    const Renderer renderer = renderer_of(scene::Scene{});
    const camera::Camera camera = pinhole(view_down_z(0.0, 0.0, 3.0));
    EXPECT_EQ(kind_of_errors(Job::make(renderer, camera, {}, nullptr).diagnostics), Kind::internal);
}

}  // namespace
}  // namespace balcony::render::test::stop_test
