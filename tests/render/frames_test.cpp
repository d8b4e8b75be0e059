// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The frames of an animation: a renderer that is moved and a job that goes on give what new ones
// give.

#include <cstring>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "balcony/motion.hpp"
#include "support.hpp"

namespace balcony::render::test::frames_test {

namespace {

// A shared mesh in three places, of which one moves, and a wall of its own that moves, too.
scene::Scene moving_scene() {
    scene::Scene scene;
    add(scene, wall(-4.0F, 9.0F), white());
    add(scene, coarse_sphere(0.4F, 24, 12), white());
    for (const double x : {-1.0, 1.0}) {
        scene::Instance copy = scene.instances.back();
        copy.world_from_mesh.setTranslation(V3d(x, 0.3, -1.0));
        scene.instances.push_back(copy);
    }
    add(scene, wall(-2.0F, 0.5F), white());
    scene::Light lamp;
    lamp.kind = scene::LightKind::point;
    lamp.position = V3d(0.0, 2.0, 2.0);
    lamp.intensity = scene::Color3f(30.0F);
    scene.lights.push_back(lamp);

    auto motion = std::make_shared<scene::Motion>();
    motion->tracks = {{scene::Interpolation::linear, 3, {0.0, 1.0}, {0, 0, 0, 0.5F, 1.0F, 0.3F}}};
    scene::Node node;
    node.translation_track = scene::TrackIndex(0);
    scene::Node above = node;
    above.world_from_parent.setTranslation(lamp.position);
    motion->nodes = {node, above};
    motion->instances = {{2, scene::NodeIndex(0)}, {4, scene::NodeIndex(0)}};
    motion->lights = {{0, scene::NodeIndex(1)}};
    motion->animations = {{"test", 1.0, 1}};
    scene.motion = std::move(motion);
    return scene;
}

constexpr double frame = 0.25;
constexpr Shutter shutter{0.5 * frame, ShutterShape::box};

Settings settings_at(double time) {
    Settings settings;
    settings.samples = 2;
    settings.time = time;
    settings.shutter = shutter;
    return settings;
}

Film empty_film() { return *make_film({.width = 96, .height = 64, .data_layers = false}); }

camera::Camera view() { return pinhole(view_down_z(0.2, 0.3, 3.0)); }

bool same(const Film& a, const Film& b) {
    return a.sum.size() == b.sum.size() &&
           std::memcmp(a.sum.data(), b.sum.data(), a.sum.size() * sizeof(a.sum[0])) == 0;
}

Film rendered_anew(const scene::Scene& scene, double time) {
    const auto renderer =
        Renderer::make(at_time(scene, time), {.interval = shutter.exposure(time)});
    Film film = empty_film();
    EXPECT_TRUE(renderer && render::render(*renderer, view(), settings_at(time), film));
    return film;
}

}  // namespace

TEST(Frames, AreThoseOfNewRenderers) {
    for (const bool moves : {true, false}) {
        scene::Scene scene = moving_scene();
        if (!moves) {
            scene.motion.reset();
        }
        auto shared = std::make_shared<const scene::Scene>(scene);
        Result<Renderer> renderer = Renderer::make(shared, {.interval = shutter.exposure(0.0)});
        ASSERT_TRUE(renderer);
        const auto shared_first = std::make_shared<Film>(empty_film());
        Film& first = *shared_first;
        Result<Job> job = Job::make(*renderer, view(), settings_at(0.0), shared_first);
        ASSERT_TRUE(job && job->run());
        ASSERT_TRUE(same(first, rendered_anew(scene, 0.0)));
        Film last = first;
        for (const double time : {frame, 3.0 * frame, 2.0 * frame}) {
            shared = at_time(*shared, time);
            renderer = renderer->moved(shared, shutter.exposure(time));
            ASSERT_TRUE(renderer);
            const auto shared_film = std::make_shared<Film>(empty_film());
            Film& film = *shared_film;
            job = job->again(*renderer, settings_at(time), shared_film);
            ASSERT_TRUE(job && job->run());
            EXPECT_TRUE(same(film, rendered_anew(scene, time))) << time;
            EXPECT_EQ(same(film, last), !moves);
            last = film;
        }
    }
}

// A moved renderer shares what stands still, but neither needs the other, or the scenes.
TEST(Frames, EarlierRenderersStayUsable) {
    const scene::Scene scene = moving_scene();
    auto shared = std::make_shared<const scene::Scene>(scene);
    std::optional<Renderer> before = *Renderer::make(shared, {.interval = shutter.exposure(0.0)});
    shared = at_time(*shared, frame);
    const Renderer after = *before->moved(shared, shutter.exposure(frame));
    shared.reset();
    const auto rendered = [](const Renderer& renderer, double time) {
        Film film = empty_film();
        EXPECT_TRUE(render::render(renderer, view(), settings_at(time), film));
        return film;
    };
    EXPECT_TRUE(same(rendered(after, frame), rendered_anew(scene, frame)));
    EXPECT_TRUE(same(rendered(*before, 0.0), rendered_anew(scene, 0.0)));
    before.reset();
    EXPECT_TRUE(same(rendered(after, frame), rendered_anew(scene, frame)));
}

// A scene with other parts is what a renderer makes of it anew.
TEST(Frames, RenderersMoveToEditedScenes) {
    const scene::Scene scene = moving_scene();
    const Renderer renderer = renderer_of(scene);
    scene::Scene more = scene;
    more.instances.push_back(more.instances.back());
    more.instances.back().world_from_mesh *= scene::M44d().translate(V3d(0.2, 0.1, 0.3));
    scene::Scene fewer = scene;
    fewer.motion.reset();
    fewer.instances.pop_back();
    scene::Scene clear = scene;
    for (scene::Material& material : clear.materials) {
        material.alpha_mode = scene::AlphaMode::blend;
        material.alpha = 0.5F;
    }
    for (const scene::Scene* const edited : {&more, &fewer, &clear}) {
        const auto moved = renderer.moved(at_time(*edited, frame), shutter.exposure(frame));
        ASSERT_TRUE(moved) << to_text(moved.diagnostics);
        Film film = empty_film();
        EXPECT_TRUE(render::render(*moved, view(), settings_at(frame), film));
        EXPECT_TRUE(same(film, rendered_anew(*edited, frame)));
        EXPECT_FALSE(same(film, rendered_anew(scene, frame)));
    }
}

TEST(Frames, RenderersDoNotMoveToOtherTextures) {
    scene::Scene scene = moving_scene();
    const Result<Renderer> renderer = Renderer::make(std::make_shared<const scene::Scene>(scene));
    const auto pixel = [](int, int) { return std::vector<std::uint8_t>{255, 0, 0}; };
    add_texture(scene, encode_png(1, 1, 3, pixel));
    scene::Scene broken = moving_scene();
    broken.instances[0].mesh = scene::MeshIndex(99);
    for (const auto& [other, kind] :
         {std::pair{std::make_shared<const scene::Scene>(scene), Kind::usage},
          {std::shared_ptr<const scene::Scene>(), Kind::usage},
          {std::make_shared<const scene::Scene>(broken), Kind::internal}}) {
        const Result<Renderer> moved = renderer->moved(other, {0.0, 0.0});
        EXPECT_FALSE(moved);
        EXPECT_EQ(moved.diagnostics.at(0).kind, kind);
    }
}

// A wall without lamps is lit by a sky if the picture could show one, unless the light is chosen.
TEST(Frames, SubstituteLightIsReportedAndCanBeHeld) {
    scene::Scene scene;
    add(scene, wall(-1.0F, 9.0F), white());
    scene.default_light = true;
    const auto renderer = Renderer::make(std::make_shared<scene::Scene>(scene));
    ASSERT_TRUE(renderer);
    Film film = empty_film();
    Settings settings = settings_at(0.0);
    settings.shutter = {};
    const auto chosen = render::render(*renderer, view(), settings, film);
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->substitute, SubstituteLight::sky);
    for (const SubstituteLight light : {SubstituteLight::sky, SubstituteLight::eye}) {
        Film held = empty_film();
        settings.light.substitute = light;
        const auto summary = render::render(*renderer, view(), settings, held);
        ASSERT_TRUE(summary);
        EXPECT_EQ(summary->substitute, light);
        EXPECT_EQ(same(held, film), light == SubstituteLight::sky);
        const auto unused = std::make_shared<Film>(empty_film());
        const Result<Job> job = Job::make(*renderer, view(), settings, unused);
        ASSERT_TRUE(job);
        EXPECT_EQ(job->substitute(), light) << "before the job runs";
    }
}

// A sun over a floor, of 10 lux, and the light of the soft sky beside it.
TEST(Frames, ASkyBesideSunsFillsTheShadows) {
    scene::Scene scene;
    add(scene, parallelogram({-9.0F, -1.0F, 9.0F}, {18.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -18.0F}),
        white());
    scene::Light sun;
    sun.kind = scene::LightKind::directional;
    sun.direction = V3d(0.0, -1.0, 0.0);
    sun.intensity = scene::Color3f(10.0F);
    scene.lights.push_back(sun);
    const camera::Camera from_above =
        pinhole({V3d(0.0, 3.0, 0.0), V3d(0.0, -1.0, 0.0), V3d(1.0, 0.0, 0.0), V3d(0.0, 0.0, -1.0)});
    const auto lit = [&](const LightSettings& light) {
        Film film = empty_film();
        Settings settings = settings_at(0.0);
        settings.shutter = {};
        settings.light = light;
        const auto renderer = Renderer::make(std::make_shared<scene::Scene>(scene));
        const auto summary = render::render(*renderer, from_above, settings, film);
        EXPECT_TRUE(summary);
        float sum = 0.0F;
        for (std::size_t x = 0; x < film.width; ++x) {
            sum += film.pixel(x, film.height / 2).g;
        }
        return std::pair(sum, summary ? summary->substitute : std::nullopt);
    };
    const auto [alone, nothing] = lit({});
    EXPECT_EQ(nothing, std::nullopt);
    const auto [filled, sky] = lit({.sky_beside_suns = true});
    EXPECT_EQ(sky, SubstituteLight::sky);
    EXPECT_NEAR(filled / alone, 1.2F, 0.03F) << "a fifth of the sun's";
    EXPECT_EQ(lit({.substitute = SubstituteLight::none, .sky_beside_suns = true}).first, alone);
    // Not beside other light.
    scene::Light lamp;
    lamp.position = V3d(0.0, 5.0, 0.0);
    scene.lights.push_back(lamp);
    EXPECT_EQ(lit({.sky_beside_suns = true}).second, std::nullopt);
}

}  // namespace balcony::render::test::frames_test
