// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Passes, threads, interruption, rays that are not there.

#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <set>
#include <stop_token>

#include <gtest/gtest.h>

#include "render/integrators/integrator.hpp"
#include "support.hpp"

namespace balcony::render::test::film_test {
namespace {

using camera::Emitter;
using camera::ObjectPoint;
using camera::ObjectVector;
using camera::ParameterPoint;

// Walls in several colours, a mirror, a lamp and a texture.
scene::Scene busy_scene() {
    scene::Scene scene;
    add(scene, wall(-5.0F, 10.0F), white());
    scene::Material mirror = white();
    mirror.metallic = 1.0F;
    mirror.roughness = 0.0F;
    add(scene, parallelogram({-2.0F, -2.0F, -4.0F}, {2.0F, 0.0F, 1.0F}, {0.0F, 3.0F, 0.5F}),
        mirror);
    scene::Material textured = white();
    textured.base_color_texture.index =
        add_texture(scene, encode_png(64, 64, 3, [](int x, int y) {
                        const auto c = static_cast<std::uint8_t>(x * 4 ^ y * 3);
                        return std::vector<std::uint8_t>{c, static_cast<std::uint8_t>(255 - c), 90};
                    }));
    add(scene, parallelogram({0.2F, -2.0F, -3.0F}, {2.0F, 0.0F, -1.0F}, {0.0F, 3.0F, -0.5F}),
        textured);
    scene::Light lamp;
    lamp.position = V3d(1.0, 3.0, 1.0);
    lamp.intensity = Color3f(40.0F);
    scene.lights.push_back(lamp);
    return scene;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

bool same_bits(const Film& a, const Film& b) {
    const DataLayers& p = *a.layers;
    const DataLayers& q = *b.layers;
    return same_bits(a.sum, b.sum) && a.passes == b.passes &&
           same_bits(p.ray_length, q.ray_length) && same_bits(p.position, q.position) &&
           same_bits(p.normal, q.normal) && same_bits(p.albedo, q.albedo) &&
           same_bits(p.object, q.object) && same_bits(p.origin, q.origin) &&
           same_bits(p.direction, q.direction) && same_bits(p.parameters, q.parameters) &&
           same_bits(p.valid, q.valid);
}

TEST(Film, DoesNotDependOnTheNumberOfThreads) {
    const scene::Scene scene = busy_scene();
    const camera::Camera camera = pinhole(view_down_z(0.0, 0.0, 1.0));
    Request asked = request(150, 100, "direct", 3);
    asked.threads = 1;
    const Rendered one = render(scene, camera, asked);
    for (const std::size_t threads : {2U, 5U, 0U}) {
        asked.threads = threads;
        EXPECT_TRUE(same_bits(one.film, render(scene, camera, asked).film)) << threads;
    }
    asked.samples = 4;
    EXPECT_FALSE(same_bits(one.film, render(scene, camera, asked).film));
}

TEST(Film, AnEdgeThroughAPixelIsAveraged) {
    scene::Scene scene;
    // Covers the left half of the picture's one pixel.
    add(scene, parallelogram({-9.0F, -9.0F, -1.0F}, {9.0F, 0.0F, 0.0F}, {0.0F, 18.0F, 0.0F}),
        white());
    const Rendered picture =
        render(scene, orthographic(view_down_z(0.0, 0.0, 0.0)), request(1, 1, "preview", 256));
    // One sample more or less on the edge itself, and the sequence's discrepancy of a few samples.
    EXPECT_NEAR(picture.film.pixel(0, 0).a, 0.5F, 4.0F / 256.0F);
}

// Rays exist in the left half only.
camera::Camera half_camera() {
    return make_camera({[](const ParameterPoint& p, Emitter& emit) {
                            emit.require(p.u < 0.0);
                            return ObjectPoint{p.u, p.v, emit(0.0)};
                        },
                        [](const ParameterPoint&, Emitter& emit) {
                            return ObjectVector{emit(0.0), emit(0.0), emit(-1.0)};
                        }});
}

TEST(Film, PointsWithoutRayAreCountedAndTransparent) {
    scene::Scene scene;
    add(scene, wall(-1.0F, 5.0F), white());
    Request asked = request(50, 40, "preview", 2);
    asked.background = Color3f(1.0F);
    const Rendered picture = render(scene, half_camera(), asked);
    EXPECT_EQ(picture.summary.camera_rays, 2U * 50U * 40U);
    EXPECT_EQ(picture.summary.invalid_pixels, 25U * 40U);
    EXPECT_EQ(picture.summary.repaired, 0U);
    for (std::size_t x = 0; x < 50; ++x) {
        // The column on the border has its second sample on either side.
        if (x == 24 || x == 25) {
            continue;
        }
        EXPECT_EQ(picture.film.pixel(x, 7).a, x < 25 ? 1.0F : 0.0F);
        EXPECT_EQ(picture.film.pixel(x, 7).r, x < 25 ? 1.0F : 0.0F);
        EXPECT_EQ(picture.film.layers->valid[7 * 50 + x], x < 25 ? 1 : 0);
        EXPECT_EQ(picture.film.layers->object[7 * 50 + x], x < 25 ? 1U : 0U);
    }
}

// Rays exist in the picture and nowhere else, neither beyond its border nor on it.
TEST(Film, TheFilterNeverSamplesBeyondThePicture) {
    scene::Scene scene;
    add(scene, wall(-1.0F, 5.0F), white());
    const auto origin = [](const ParameterPoint& p, Emitter& emit) {
        emit.require(abs(p.u) < emit(1.0) && abs(p.v) < emit(1.0));
        return ObjectPoint{p.u, p.v, emit(0.0)};
    };
    const auto direction = [](const ParameterPoint&, Emitter& emit) {
        return ObjectVector{emit(0.0), emit(0.0), emit(-1.0)};
    };
    const Rendered picture =
        render(scene, make_camera({origin, direction}), request(70, 40, "preview", 16));
    EXPECT_EQ(picture.summary.invalid_rays, 0U);
    for (const auto& [x, y] : {std::pair(0U, 0U), {69U, 20U}, {30U, 39U}, {69U, 39U}}) {
        EXPECT_EQ(picture.film.pixel(x, y).a, 1.0F) << x << ", " << y;
    }
}

// log and a square root of negative numbers, a division by 0, an origin beyond floats.
TEST(Film, ACameraThatGivesNoNumbersGivesNoRays) {
    scene::Scene scene;
    add(scene, wall(-1.0F, 5.0F), white());
    const auto origin = [](int kind) {
        return [kind](const ParameterPoint& p, Emitter& emit) -> ObjectPoint {
            const expr::Expr bad = kind == 0   ? log(p.u - 2.0)
                                   : kind == 1 ? 1.0 / (p.u - p.u * 1.0)
                                               : exp(p.u + 200.0);
            return {bad, p.v, emit(0.0)};
        };
    };
    for (int kind = 0; kind < 3; ++kind) {
        const Rendered picture =
            render(scene,
                   make_camera({origin(kind),
                                [](const ParameterPoint&, Emitter& emit) {
                                    return ObjectVector{emit(0.0), emit(0.0), emit(-1.0)};
                                }}),
                   request(8, 8, "direct"));
        EXPECT_EQ(picture.summary.invalid_pixels, 64U) << kind;
        EXPECT_EQ(picture.film.pixel(3, 3), Color4f(0.0F)) << kind;
    }
}

TEST(Film, RadianceThatIsNoNumberIsReplacedAndCounted) {
    scene::Scene scene;
    scene::Material broken = white();
    broken.emission = Color3f(std::numeric_limits<float>::quiet_NaN());
    add(scene, wall(-1.0F, 5.0F), broken);
    const Rendered picture =
        render(scene, orthographic(view_down_z(0.0, 0.0, 0.0)), request(8, 8, "preview", 2));
    EXPECT_EQ(picture.summary.repaired, 128U);
    EXPECT_EQ(picture.film.pixel(3, 3).r, 0.0F);
}

TEST(Film, ProgressCountsEveryTileOfEveryPass) {
    scene::Scene scene;
    add(scene, wall(-1.0F, 5.0F), white());
    const Result<Renderer> renderer = Renderer::make(std::make_shared<scene::Scene>(scene));
    std::size_t calls = 0;
    std::vector<std::uint32_t> changes(100UL * 70UL);
    Progress last;
    const Request asked = request(100, 70, "preview", 3);
    Film film = *make_film(asked.layout);
    const Result<Summary> summary =
        render::render(*renderer, orthographic(view_down_z(0.0, 0.0, 0.0)), asked, film,
                       [&](const Progress& progress) {
                           ++calls;
                           EXPECT_EQ(progress.tiles_done, calls);
                           const Region& part = progress.region;
                           for (std::size_t y = part.y; y < part.y + part.height; ++y) {
                               for (std::size_t x = part.x; x < part.x + part.width; ++x) {
                                   ++changes.at(y * 100 + x);
                               }
                           }
                           last = progress;
                       });
    EXPECT_EQ(changes, std::vector<std::uint32_t>(100UL * 70UL, 3));
    EXPECT_EQ(calls, last.tiles);
    EXPECT_EQ(last.pass, 2U);
    EXPECT_EQ(last.passes, 3U);
    EXPECT_EQ(last.tiles, 3 * film.tile_count());
    EXPECT_EQ(summary->passes, 3U);
    EXPECT_FALSE(summary->interrupted);
    EXPECT_GT(summary->camera_share, 0.0);
    EXPECT_LT(summary->camera_share, 1.0);
}

TEST(Film, AStoppedRenderKeepsTheCompletedPart) {
    scene::Scene scene;
    add(scene, wall(-1.0F, 5.0F), white());
    const Result<Renderer> renderer = Renderer::make(std::make_shared<scene::Scene>(scene));
    std::stop_source stop;
    Request asked = request(200, 100, "preview", 1000);
    asked.threads = 2;
    Film film = *make_film(asked.layout);
    const Result<Summary> summary = render::render(
        *renderer, orthographic(view_down_z(0.0, 0.0, 0.0)), asked, film,
        [&](const Progress& progress) {
            if (progress.pass == 1) {
                stop.request_stop();
            }
        },
        stop.get_token());
    ASSERT_TRUE(summary);
    EXPECT_TRUE(summary->interrupted);
    EXPECT_EQ(summary->passes, 1U);
    std::size_t twice = 0;
    for (std::size_t y = 0; y < 100; ++y) {
        for (std::size_t x = 0; x < 200; ++x) {
            const std::uint32_t samples = film.samples(x, y);
            twice += samples == 2 ? 1 : 0;
            ASSERT_TRUE(samples == 1 || samples == 2);
            ASSERT_EQ(film.pixel(x, y), Color4f(1.0F));
        }
    }
    EXPECT_GT(twice, 0U);
    EXPECT_LT(twice, 200U * 100U);
}

TEST(Film, StoppedBeforeTheStartIsEmpty) {
    scene::Scene scene;
    add(scene, wall(-1.0F, 5.0F), white());
    const Result<Renderer> renderer = Renderer::make(std::make_shared<scene::Scene>(scene));
    std::stop_source stop;
    stop.request_stop();
    const Request asked = request(20, 10, "preview");
    Film film = *make_film(asked.layout);
    const Result<Summary> summary = render::render(
        *renderer, orthographic(view_down_z(0.0, 0.0, 0.0)), asked, film, {}, stop.get_token());
    ASSERT_TRUE(summary);
    EXPECT_TRUE(summary->interrupted);
    EXPECT_EQ(summary->passes, 0U);
    EXPECT_EQ(film.pixel(3, 3), Color4f(0.0F));
}

TEST(Film, SettingsOutOfRangeAreErrors) {
    const Result<Renderer> renderer = Renderer::make(std::make_shared<scene::Scene>());
    ASSERT_TRUE(renderer);
    const camera::Camera camera = orthographic(view_down_z(0.0, 0.0, 0.0));
    const auto film = std::make_shared<Film>(*make_film({.width = 4, .height = 4}));
    const auto refused = [&](void (*change)(Settings&)) {
        Settings asked = request(4, 4, "preview");
        EXPECT_TRUE(Job::make(*renderer, camera, asked, film));
        change(asked);
        const Result<Job> job = Job::make(*renderer, camera, asked, film);
        return !job && has_errors(job.diagnostics);
    };
    EXPECT_TRUE(refused([](Settings& s) { s.samples = 0; }));
    EXPECT_TRUE(refused([](Settings& s) { s.threads = 1000000; }));
    EXPECT_TRUE(refused([](Settings& s) { s.time = std::nan(""); }));
    EXPECT_TRUE(refused([](Settings& s) { s.integrator = "prview"; }));
}

TEST(Film, LayoutsOutOfRangeAreErrors) {
    EXPECT_TRUE(make_film({.width = 4, .height = 4, .window = Region{1, 2, 3, 2}}));
    for (const FilmLayout& layout :
         {FilmLayout{.width = 0}, FilmLayout{.height = std::size_t{1} << 40},
          FilmLayout{.width = 1000000, .height = 1000000},
          FilmLayout{.width = 4, .height = 4, .window = Region{0, 0, 0, 4}},
          FilmLayout{.width = 4, .height = 4, .window = Region{1, 2, 3, 3}},
          FilmLayout{.width = 4, .height = 4, .window = Region{~std::size_t{0}, 0, 2, 2}}}) {
        EXPECT_FALSE(make_film(layout)) << layout.width << " x " << layout.height;
    }
}

TEST(Film, IntegratorsAreListedAndFoundByName) {
    std::set<std::string_view> names;
    for (const IntegratorInfo& info : integrators()) {
        EXPECT_NE(find_integrator(info.name), nullptr) << info.name;
        EXPECT_FALSE(info.meaning.empty()) << info.name;
        names.insert(info.name);
    }
    EXPECT_EQ(names.size(), integrators().size());
    EXPECT_TRUE(names.contains("preview") && names.contains("direct"));
    EXPECT_EQ(find_integrator("no such integrator"), nullptr);
}

}  // namespace
}  // namespace balcony::render::test::film_test
