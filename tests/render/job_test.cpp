// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Jobs: regions, passes that start anywhere, tiles that differ in their numbers of samples, several
// at once; and the precision of what a film adds up.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "film/sums/tile_image.hpp"
#include "support.hpp"

namespace balcony::render::test::job_test {
namespace {

constexpr std::size_t width = 150;
constexpr std::size_t height = 75;

// Two walls, one of them a mirror and seen through a third that is half transparent, and a lamp.
// The camera's axis meets the walls' diagonals, where two triangles are equally near.
scene::Scene varied_scene() {
    scene::Scene scene;
    add(scene, wall(-5.0F, 10.0F), white());
    scene::Material mirror = white();
    mirror.metallic = 1.0F;
    mirror.roughness = 0.0F;
    add(scene, parallelogram({-2.0F, -2.0F, -4.0F}, {2.0F, 0.0F, 1.0F}, {0.0F, 3.0F, 0.5F}),
        mirror);
    scene::Material glass = white();
    glass.alpha_mode = scene::AlphaMode::blend;
    glass.alpha = 0.3F;
    add(scene, wall(-2.0F, 0.7F), glass);
    scene::Light lamp;
    lamp.position = V3d(1.0, 3.0, 1.0);
    lamp.intensity = Color3f(40.0F);
    scene.lights.push_back(lamp);
    return scene;
}

Renderer varied_renderer() {
    return *Renderer::make(std::make_shared<scene::Scene>(varied_scene()));
}

camera::Camera varied_camera() { return pinhole(view_down_z(0.0, 0.0, 1.0)); }

Settings settings(std::size_t samples) { return request(width, height, "direct", samples); }

Film empty_film(std::optional<Region> window = {}, bool second_moment = false) {
    return *make_film(
        {.width = width, .height = height, .window = window, .second_moment = second_moment});
}

Film rendered(const Renderer& renderer, std::size_t samples) {
    Film film = empty_film();
    EXPECT_TRUE(render::render(renderer, varied_camera(), settings(samples), film));
    return film;
}

template <class T>
bool same_bits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof(T)) == 0;
}

// Where a film's sums or data differ from those of the whole picture.
std::size_t differences(const Film& part, const Film& whole) {
    std::size_t found = 0;
    for (std::size_t y = part.window.y; y < part.window.y + part.window.height; ++y) {
        for (std::size_t x = part.window.x; x < part.window.x + part.window.width; ++x) {
            const std::size_t i = part.index(x, y);
            const std::size_t j = whole.index(x, y);
            const DataLayers& p = *part.layers;
            const DataLayers& q = *whole.layers;
            found += same_bits(part.sum[i], whole.sum[j]) &&
                             same_bits(p.ray_length[i], q.ray_length[j]) &&
                             same_bits(p.position[i], q.position[j]) &&
                             same_bits(p.normal[i], q.normal[j]) &&
                             same_bits(p.origin[i], q.origin[j]) &&
                             same_bits(p.direction[i], q.direction[j]) &&
                             p.object[i] == q.object[j] && p.valid[i] == q.valid[j]
                         ? 0
                         : 1;
        }
    }
    return found;
}

// Cuts that lie on no border of a tile or packet.
TEST(Job, RegionsPutTogetherAreTheWhole) {
    const Renderer renderer = varied_renderer();
    const Film whole = rendered(renderer, 3);
    std::size_t pixels = 0;
    std::uint64_t rays = 0;
    for (const Region& window : {Region{0, 0, 61, 75}, Region{61, 0, 89, 33}, Region{61, 33, 1, 42},
                                 Region{62, 33, 88, 42}}) {
        Film part = empty_film(window);
        const auto summary = render::render(renderer, varied_camera(), settings(3), part);
        ASSERT_TRUE(summary);
        EXPECT_EQ(differences(part, whole), 0U) << window.x << ", " << window.y;
        pixels += part.sum.size();
        rays += summary->camera_rays;
    }
    EXPECT_EQ(pixels, whole.sum.size());
    EXPECT_EQ(rays, 3 * pixels);
}

TEST(Job, GoesOnWhereAnotherStopped) {
    const Renderer renderer = varied_renderer();
    Film film = empty_film();
    for (const std::size_t samples : {1U, 2U, 5U}) {
        const auto summary = render::render(renderer, varied_camera(), settings(samples), film);
        ASSERT_TRUE(summary);
        EXPECT_EQ(summary->passes, samples);
        EXPECT_EQ(differences(film, rendered(renderer, samples)), 0U) << samples;
    }
    // There is nothing left to do.
    EXPECT_EQ(render::render(renderer, varied_camera(), settings(5), film)->camera_rays, 0U);
}

// Stopped in the middle of a pass, so that some tiles are ahead.
TEST(Job, GoesOnFromTilesThatDiffer) {
    const Renderer renderer = varied_renderer();
    const auto shared_film = std::make_shared<Film>(empty_film());
    Film& film = *shared_film;
    Result<Job> job = Job::make(renderer, varied_camera(), settings(4), shared_film);
    ASSERT_TRUE(job);
    std::stop_source stop;
    const auto stop_early = [&](const Progress& progress) {
        if (progress.tiles_done == film.tile_count() + 3) {
            stop.request_stop();
        }
    };
    const auto stopped = job->run(stop_early, stop.get_token());
    ASSERT_TRUE(stopped && stopped->interrupted);
    EXPECT_NE(*std::min_element(film.passes.begin(), film.passes.end()),
              *std::max_element(film.passes.begin(), film.passes.end()));
    const auto finished = job->run();
    ASSERT_TRUE(finished);
    EXPECT_FALSE(finished->interrupted);
    EXPECT_EQ(finished->passes, 4U);
    EXPECT_EQ(differences(film, rendered(renderer, 4)), 0U);
}

// Passes made apart, added in their order, are the passes of one render.
TEST(Job, StartsAtAnyPass) {
    const Renderer renderer = varied_renderer();
    const Film whole = rendered(renderer, 5);
    Film total = rendered(renderer, 3);
    for (const std::size_t first : {3U, 4U}) {
        Film later = empty_film();
        later.first_pass = first;
        ASSERT_TRUE(render::render(renderer, varied_camera(), settings(1), later));
        EXPECT_EQ(later.layers->valid[0], 0) << "pass 0 alone lies at the pixel centres";
        for (std::size_t i = 0; i < total.sum.size(); ++i) {
            total.sum[i] += later.sum[i];
        }
    }
    EXPECT_EQ(differences(total, whole), 0U);
}

TEST(Job, TilesMayDifferInSamples) {
    const Renderer renderer = varied_renderer();
    const auto shared_film = std::make_shared<Film>(empty_film());
    Film& film = *shared_film;
    Result<Job> job = Job::make(renderer, varied_camera(), settings(2), shared_film);
    ASSERT_TRUE(job);
    std::vector<std::uint32_t> passes(film.tile_count());
    for (std::size_t tile = 0; tile < passes.size(); ++tile) {
        passes[tile] = static_cast<std::uint32_t>(tile % 4);
    }
    const auto summary = job->run(passes);
    ASSERT_TRUE(summary);
    EXPECT_EQ(film.passes, passes);
    EXPECT_EQ(summary->passes, 0U);
    EXPECT_FALSE(summary->interrupted);
    std::array<std::optional<Film>, 4> even;
    for (std::size_t count = 1; count < even.size(); ++count) {
        even[count] = rendered(renderer, count);
    }
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const std::uint32_t count = passes[film.tile_of(x, y)];
            ASSERT_EQ(film.samples(x, y), count);
            ASSERT_EQ(film.pixel(x, y), count == 0 ? Color4f(0.0F) : even[count]->pixel(x, y));
        }
    }
    EXPECT_FALSE(job->run(std::vector<std::uint32_t>(film.tile_count() + 1, 1)));
}

TEST(Job, TilesCoverEveryPixelOnce) {
    for (const std::optional<Region>& window :
         {std::optional<Region>{}, std::optional(Region{63, 31, 2, 2}),
          std::optional(Region{64, 64, 86, 11})}) {
        const Film film = empty_film(window);
        std::vector<int> covered(film.sum.size());
        for (std::size_t tile = 0; tile < film.tile_count(); ++tile) {
            const Region region = film.tile(tile);
            for (std::size_t y = region.y; y < region.y + region.height; ++y) {
                for (std::size_t x = region.x; x < region.x + region.width; ++x) {
                    if (film.window.contains(x, y)) {
                        ++covered[film.index(x, y)];
                        EXPECT_EQ(film.tile_of(x, y), tile);
                    }
                }
            }
        }
        EXPECT_EQ(std::count(covered.begin(), covered.end(), 1),
                  static_cast<std::ptrdiff_t>(covered.size()));
    }
}

TEST(Job, TwoAtOnceDoNotDisturbEachOther) {
    const Renderer renderer = varied_renderer();
    const Film alone = rendered(renderer, 4);
    std::array<Film, 2> films{empty_film(), empty_film()};
    {
        std::vector<std::jthread> threads;
        for (Film& film : films) {
            threads.emplace_back([&renderer, &film] {
                EXPECT_TRUE(render::render(renderer, varied_camera(), settings(4), film));
            });
        }
    }
    EXPECT_EQ(differences(films[0], alone), 0U);
    EXPECT_EQ(differences(films[1], alone), 0U);
}

TEST(Job, TheSecondMomentIsThatOfTheSamples) {
    constexpr std::size_t samples = 6;
    const Renderer renderer = varied_renderer();
    Film film = empty_film({}, true);
    ASSERT_TRUE(render::render(renderer, varied_camera(), settings(samples), film));
    std::vector<Film> passes;
    for (std::size_t pass = 0; pass < samples; ++pass) {
        passes.push_back(empty_film());
        passes.back().first_pass = pass;
        ASSERT_TRUE(render::render(renderer, varied_camera(), settings(1), passes.back()));
    }
    for (std::size_t y = 0; y < height; y += 5) {
        for (std::size_t x = 0; x < width; x += 5) {
            double mean = 0.0;
            for (const Film& pass : passes) {
                mean += pass.sum[pass.index(x, y)].g / samples;
            }
            double variance = 0.0;
            for (const Film& pass : passes) {
                variance += std::pow(pass.sum[pass.index(x, y)].g - mean, 2.0) / (samples - 1);
            }
            // Radiance here is below 10, and squares of it cancel in doubles.
            EXPECT_NEAR(film.variance(x, y).g, variance, 1e-12);
        }
    }
}

TEST(Job, AFilmOfAnotherSizeThanItSaysIsAnError) {
    const Renderer renderer = varied_renderer();
    const auto refused = [&](void (*change)(Film&)) {
        const auto shared_film = std::make_shared<Film>(empty_film());
        Film& film = *shared_film;
        change(film);
        return !Job::make(renderer, varied_camera(), settings(1), shared_film);
    };
    EXPECT_FALSE(refused([](Film&) {}));
    EXPECT_TRUE(refused([](Film& film) { film.sum.pop_back(); }));
    EXPECT_TRUE(refused([](Film& film) { film.passes.push_back(0); }));
    EXPECT_TRUE(refused([](Film& film) { film.layers->valid.pop_back(); }));
    EXPECT_TRUE(refused([](Film& film) { film.window.x = width; }));
    EXPECT_TRUE(refused([](Film& film) { film = Film{}; }));
}

TEST(Job, LimitsOfBouncesConcernTheirIntegratorAlone) {
    const Renderer renderer = varied_renderer();
    Settings asked = settings(1);
    const auto refused = [&] {
        return !Job::make(renderer, varied_camera(), asked, std::make_shared<Film>(empty_film()));
    };
    asked.integrator = "path";
    asked.path.bounces.glossy = BounceLimits::most;
    EXPECT_FALSE(refused());
    ++asked.path.bounces.glossy;
    EXPECT_TRUE(refused());
    asked.integrator = "direct";
    EXPECT_FALSE(refused());
}

// A sum of n doubles errs by n roundings of 1.1e-16 at most: here 3e-11 of it, less than a float
// tells apart. A float's own sum would be off by 1e-2.
TEST(FilmPrecision, ManySamplesKeepTheirMeanAndVariance) {
    constexpr std::uint32_t samples = 300000;
    Film film = *make_film({.width = 2, .height = 1, .data_layers = false, .second_moment = true});
    TileImage image{{0, 0, 2, 1}, std::vector<Color4f>(2)};
    std::mt19937 random(5);
    std::exponential_distribution<float> noise(1.0F);
    long double mean = 0.0L;
    long double square = 0.0L;
    for (std::uint32_t i = 0; i < samples; ++i) {
        const float value = noise(random);
        image.light = {Color4f(0.1F, 1e-4F, 1e4F, 1.0F), Color4f(value)};
        add_pass(film, 0, image);
        mean += static_cast<long double>(value) / samples;
        square += static_cast<long double>(value) * static_cast<long double>(value) / samples;
    }
    EXPECT_EQ(film.samples(0, 0), samples);
    EXPECT_EQ(film.pixel(0, 0), Color4f(0.1F, 1e-4F, 1e4F, 1.0F));
    EXPECT_EQ(film.pixel(1, 0).r, static_cast<float>(mean));
    const auto variance = static_cast<double>((square - mean * mean) * samples / (samples - 1.0L));
    EXPECT_NEAR(film.variance(1, 0).r, variance, 1e-9);
    EXPECT_NEAR(film.variance(0, 0).b, 0.0, 1e8 * 1e-9);
}

}  // namespace
}  // namespace balcony::render::test::job_test
