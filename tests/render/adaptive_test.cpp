// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Adaptive sampling: more samples where the picture is noisy, to a stated level, whatever happens
// on the way.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::render::test::adaptive_test {
namespace {

constexpr std::size_t width = 128;
constexpr std::size_t height = 64;

// A wall in the left half of the picture, a fence of thin bars in the right half, in front of
// nothing.
scene::Scene wall_and_fence(const scene::Material& material = white()) {
    scene::Scene scene;
    add(scene, parallelogram({-9.0F, -9.0F, -1.0F}, {9.0F, 0.0F, 0.0F}, {0.0F, 18.0F, 0.0F}),
        material);
    for (int bar = 0; bar < 60; ++bar) {
        const float x = 0.1F + 0.017F * static_cast<float>(bar);
        add(scene, parallelogram({x, -9.0F, -1.0F}, {0.006F, 0.0F, 0.0F}, {0.001F, 18.0F, 0.0F}),
            material);
    }
    return scene;
}

Request adaptive_request(double noise, std::size_t max_samples) {
    Request asked = request(width, height, "preview", max_samples);
    asked.sampling.noise = noise;
    return asked;
}

camera::Camera front() { return orthographic(view_down_z(0.0, 0.0, 0.0)); }

TEST(Adaptive, SamplesWhereThereIsNoise) {
    const Film film = render(wall_and_fence(), front(), adaptive_request(0.02, 512)).film;
    for (std::size_t y = 0; y < height; ++y) {
        EXPECT_EQ(film.samples(20, y), 16U) << "the wall is even";
        std::uint32_t most = 0;
        for (std::size_t x = 80; x < 120; ++x) {
            most = std::max(most, film.samples(x, y));
        }
        EXPECT_GT(most, 16U) << "bars cross pixels";
    }
}

// The light of a square lamp behind a smaller screen, whose noise is that of random directions.
scene::Scene wall_in_a_penumbra() {
    scene::Scene scene;
    add(scene, wall(-1.0F, 9.0F), white());
    add(scene, parallelogram({-0.4F, -0.3F, 0.4F}, {0.6F, 0.0F, 0.0F}, {0.0F, 0.6F, 0.0F}),
        white());
    scene::Material lamp = white();
    lamp.base_color = Color3f(0.0F);
    lamp.emission = Color3f(3.0F);
    add(scene, parallelogram({-1.0F, -1.0F, 1.0F}, {0.0F, 2.0F, 0.0F}, {2.0F, 0.0F, 0.0F}), lamp);
    return scene;
}

// A pixel stops at the first power of two where the mean of 25 estimates is below the square of the
// level. The expectation of an estimate is the square of the error, and 25 of them deviate by the
// factor sqrt(2/25). To stop at twice the square of the level is therefore rare, 1 in 50, and each
// doubling halves the square: on average over the powers, it is 0.8 of the square of the level,
// and never above, wherever between two powers of two the level is reached.
TEST(Adaptive, ReachesTheLevel) {
    const auto asked = [](double noise, std::size_t max_samples) {
        Request wanted = request(32, 32, "path", max_samples);
        wanted.path.bounces.all = 0;
        wanted.sampling.noise = noise;
        wanted.sampling.white = 1.0;
        return wanted;
    };
    const scene::Scene scene = wall_in_a_penumbra();
    const Film reference = render(scene, front(), asked(0.0, 4096)).film;
    for (const double level : {0.1, 0.05, 0.025}) {
        const Film film = render(scene, front(), asked(level, 4096)).film;
        double squares = 0.0;
        for (std::size_t y = 0; y < 32; ++y) {
            for (std::size_t x = 0; x < 32; ++x) {
                const double truth = reference.pixel(x, y).g;
                const double error = film.pixel(x, y).g - truth;
                squares += error * error / truth;
            }
        }
        const double found = std::sqrt(squares / (32.0 * 32.0));
        EXPECT_LT(found, level);
    }
}

// A black fence has noise in its alpha alone. All pixels of a pass share the place of their sample,
// so the errors of edges are not random, and no factor between them and the level is known.
TEST(Adaptive, EdgesAreSmootherAtALowerLevel) {
    scene::Material black = white();
    black.base_color = Color3f(0.0F);
    const scene::Scene scene = wall_and_fence(black);
    const Film reference = render(scene, front(), request(width, height, "preview", 4096)).film;
    double before = 1.0;
    for (const double level : {0.05, 0.02, 0.01}) {
        const Film film = render(scene, front(), adaptive_request(level, 4096)).film;
        double squares = 0.0;
        for (std::size_t y = 0; y < height; ++y) {
            for (std::size_t x = 70; x < width; ++x) {
                const double error = double{film.pixel(x, y).a} - double{reference.pixel(x, y).a};
                squares += error * error / static_cast<double>(height * (width - 70));
            }
        }
        EXPECT_LT(squares, before);
        before = squares;
    }
}

TEST(Adaptive, TheMaximumIsKept) {
    const Film film = render(wall_and_fence(), front(), adaptive_request(1e-6, 40)).film;
    EXPECT_EQ(*std::max_element(film.pixel_passes.begin(), film.pixel_passes.end()), 40U);
}

// Where the camera shrinks the world, more of it is in a pixel.
TEST(Adaptive, SamplesWhereTheCameraShrinksTheWorld) {
    scene::Scene scene;
    for (int bar = -100; bar < 100; ++bar) {
        const float x = 0.05F * static_cast<float>(bar);
        add(scene, parallelogram({x, -9.0F, -1.0F}, {0.025F, 0.0F, 0.0F}, {0.3F, 18.0F, 0.0F}),
            white());
    }
    // x = sinh(2u): magnified in the middle, and shrunk at the border.
    const camera::Camera zoom = make_camera(
        {[](const camera::ParameterPoint& p, camera::Emitter& emit) {
             return camera::ObjectPoint{0.1 * (exp(4.0 * p.u) - exp(-4.0 * p.u)), p.v, emit(0.0)};
         },
         [](const camera::ParameterPoint&, camera::Emitter& emit) {
             return camera::ObjectVector{emit(0.0), emit(0.0), emit(-1.0)};
         }});
    const Film film = render(scene, zoom, adaptive_request(0.05, 512)).film;
    const auto mean = [&](std::size_t from, std::size_t to) {
        double total = 0.0;
        for (std::size_t y = 0; y < height; ++y) {
            for (std::size_t x = from; x < to; ++x) {
                total += film.samples(x, y);
            }
        }
        return total / static_cast<double>(height * (to - from));
    };
    EXPECT_GT(mean(width - 16, width), 1.5 * mean(width / 2 - 8, width / 2 + 8));
}

TEST(Adaptive, StopsAndThreadsChangeNothing) {
    const auto renderer = *Renderer::make(std::make_shared<scene::Scene>(wall_and_fence()));
    const auto settings = adaptive_request(0.02, 200);
    const auto whole = [&](std::size_t threads, std::size_t tiles_at_once) {
        Settings asked = settings;
        asked.threads = threads;
        const auto shared_film =
            std::make_shared<Film>(*make_film({.width = width, .height = height}));
        Film& film = *shared_film;
        Job job = *Job::make(renderer, front(), asked, shared_film);
        for (;;) {
            std::stop_source stop;
            const auto summary = job.run(
                [&](const Progress& progress) {
                    if (progress.tiles_done >= tiles_at_once) {
                        stop.request_stop();
                    }
                },
                stop.get_token());
            if (!summary->interrupted) {
                return film;
            }
        }
    };
    const Film film = whole(1, 1'000'000);
    for (const std::size_t tiles_at_once : {1U, 3U, 10U}) {
        const Film other = whole(2, tiles_at_once);
        EXPECT_EQ(other.pixel_passes, film.pixel_passes);
        EXPECT_EQ(other.passes, film.passes);
        EXPECT_EQ(std::memcmp(other.sum.data(), film.sum.data(), film.sum.size() * sizeof(Color4d)),
                  0);
    }
}

TEST(Adaptive, WithoutALevelPixelsHaveNoCounts) {
    const Film film = render(wall_and_fence(), front(), adaptive_request(0.0, 2)).film;
    EXPECT_TRUE(film.pixel_passes.empty());
    EXPECT_EQ(film.samples(3, 4), 2U);
}

TEST(Adaptive, ALevelThatIsNoNumberIsRefused) {
    const auto renderer = *Renderer::make(std::make_shared<scene::Scene>(wall_and_fence()));
    for (const double level : {-0.1, std::nan("")}) {
        const auto film = std::make_shared<Film>(*make_film({.width = 8, .height = 8}));
        EXPECT_FALSE(Job::make(renderer, front(), adaptive_request(level, 2), film));
    }
}

}  // namespace
}  // namespace balcony::render::test::adaptive_test
