// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Denoising: what it removes, what it keeps, and what it refuses.

#include "balcony/denoise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::render::test::denoise_test {
namespace {

constexpr std::size_t width = 96;
constexpr std::size_t height = 72;

// A closed room 2 wide, 1.5 high and 2 deep with a lamp in the ceiling, a red and a green wall, a
// picture of stripes on the back wall and a box, seen from its front.
scene::Scene room() {
    scene::Scene scene;
    const auto part = [&](V3f corner, V3f right, V3f up, Color3f color, Color3f emission) {
        scene::Material material;
        material.base_color = color;
        material.emission = emission;
        add(scene, parallelogram(corner, right, up), material);
    };
    const Color3f dark(0.0F);
    const Color3f grey(0.75F);
    const V3f x(2.0F, 0.0F, 0.0F);
    const V3f y(0.0F, 1.5F, 0.0F);
    const V3f z(0.0F, 0.0F, -2.0F);
    part({-1.0F, -0.75F, 0.0F}, x, z, grey, dark);                 // floor
    part({-1.0F, 0.75F, -2.0F}, x, -z, grey, dark);                // ceiling
    part({-1.0F, -0.75F, -2.0F}, x, y, grey, dark);                // back
    part({1.0F, -0.75F, 0.0F}, -x, y, grey, dark);                 // front
    part({-1.0F, -0.75F, 0.0F}, z, y, {0.7F, 0.1F, 0.1F}, dark);   // left
    part({1.0F, -0.75F, -2.0F}, -z, y, {0.1F, 0.6F, 0.1F}, dark);  // right
    part({-0.25F, 0.6F, -1.25F}, {0.5F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.5F}, dark, Color3f(15.0F));
    part({0.1F, -0.2F, -1.5F}, {0.5F, 0.0F, 0.2F}, {0.0F, 0.0F, 0.5F}, {0.5F, 0.5F, 0.8F}, dark);
    part({0.1F, -0.75F, -1.0F}, {0.5F, 0.0F, 0.2F}, {0.0F, 0.55F, 0.0F}, {0.5F, 0.5F, 0.8F}, dark);
    part({0.1F, -0.75F, -1.5F}, {0.0F, 0.0F, 0.5F}, {0.0F, 0.55F, 0.0F}, {0.5F, 0.5F, 0.8F}, dark);
    for (int i = 0; i < 5; ++i) {
        part({-0.8F + 0.12F * static_cast<float>(i), -0.1F, -1.99F}, {0.06F, 0.0F, 0.0F},
             {0.0F, 0.5F, 0.0F}, {0.1F, 0.2F, 0.6F}, dark);
    }
    return scene;
}

// A camera at the front wall, which sees all of the back.
camera::Picture view() {
    return pinhole({{0.0, 0.0, -0.05}, {0.0, 0.0, -1.0}, {0.9, 0.0, 0.0}, {0.0, 0.675, 0.0}});
}

Film rendered(std::size_t samples, bool reuse = true) {
    Request wanted = request(width, height, "path", samples);
    wanted.path.reuse = reuse;
    wanted.layout.layers = denoise_layers();
    return render(room(), view(), wanted).film;
}

const Film& noisy_room() {
    static const Film film = rendered(32);
    return film;
}

// Of the light that a display shows, up to 1: the lamp alone would otherwise count more than the
// room.
double error_of(const Film& film, const Film& reference) {
    const auto difference_of = [](float a, float b) {
        return double{std::min(a, 1.0F)} - double{std::min(b, 1.0F)};
    };
    double squares = 0.0;
    for (std::size_t i = 0; i < width * height; ++i) {
        const Color4f a = film.pixel(i % width, i / width);
        const Color4f b = reference.pixel(i % width, i / width);
        for (const double difference :
             {difference_of(a.r, b.r), difference_of(a.g, b.g), difference_of(a.b, b.b)}) {
            squares += difference * difference;
        }
    }
    return std::sqrt(squares / (3.0 * width * height));
}

const DenoiseOptions own{.denoiser = Denoiser::features};

struct Errors {
    double before = 0.0;
    double after = 0.0;
};

Errors errors(Film film, const Film& reference) {
    const double before = error_of(film, reference);
    const auto done = denoise(film, own);
    EXPECT_TRUE(done) << to_text(done.diagnostics);
    return {before, error_of(film, reference)};
}

// The noise that the reference has itself, a tenth of that of 32 independent samples, counts
// against the filter. Path reuse leaves less than half of the error of independent samples, and
// coarser noise, of which the filter removes less: it still makes the picture better than that of
// independent samples.
TEST(Denoise, HalvesTheErrorOfARoom) {
    const Film reference = rendered(512);
    const Errors independent = errors(rendered(32, false), reference);
    const Errors reused = errors(noisy_room(), reference);
    std::cout << "error of independent samples " << independent.before << " -> "
              << independent.after << ", with path reuse " << reused.before << " -> "
              << reused.after << '\n';
    EXPECT_GT(independent.after, 0.0);
    EXPECT_LT(independent.after, 0.5 * independent.before);
    EXPECT_LT(reused.before, 0.5 * independent.before);
    EXPECT_LT(reused.after, 0.25 * independent.before);
    EXPECT_LT(reused.after, independent.after);
}

TEST(Denoise, DoesNotDependOnTheNumberOfThreads) {
    Film one = noisy_room();
    Film all = noisy_room();
    ASSERT_TRUE(denoise(one, {.denoiser = Denoiser::features, .threads = 1}));
    ASSERT_TRUE(denoise(all, own));
    EXPECT_EQ(one.sum, all.sum);
}

TEST(Denoise, KeepsAlphaAndTheRenderedSums) {
    Film film = noisy_room();
    ASSERT_TRUE(denoise(film, own));
    EXPECT_EQ(film.noisy, noisy_room().sum);
    EXPECT_TRUE(film.layer_set.contains(LayerId::noisy));
    double change = 0.0;
    for (std::size_t i = 0; i < film.sum.size(); ++i) {
        EXPECT_EQ(film.sum[i].a, film.noisy[i].a);
        change += std::abs(film.sum[i].g - film.noisy[i].g);
    }
    EXPECT_GT(change, 0.0);
    EXPECT_EQ(film.rendered_light(5, 5), noisy_room().light(5, 5));
    EXPECT_EQ(film.variance(5, 5), noisy_room().variance(5, 5));
}

// A film whose samples are known: a step of the albedo in the middle, with noise on the light or
// not.
Film film_with_step(double noise) {
    Film film = *make_film({.width = 48, .height = 32, .layers = denoise_layers()});
    film.passes.assign(film.tile_count(), 16);
    std::uint32_t state = 1;
    const auto random = [&state] {  // From -1 to 1.
        state = state * 1664525U + 1013904223U;
        return static_cast<double>(state) / 2147483648.0 - 1.0;
    };
    for (std::size_t i = 0; i < film.sum.size(); ++i) {
        const bool right = i % 48 >= 24;
        const double level = right ? 0.8 : 0.2;
        for (int sample = 0; sample < 16; ++sample) {
            const double light = level * (1.0 + noise * random());
            film.sum[i] += Color4d(light, light, light, 1.0);
            film.sum_of_squares[i] += Color4d(light * light, light * light, light * light, 1.0);
        }
        film.means.albedo[i].mean = V3f(right ? 0.8F : 0.2F);
        film.means.normal[i].mean = V3f(0.0F, 0.0F, 1.0F);
        film.means.position[i].mean =
            V3f(static_cast<float>(i % 48), static_cast<float>(i / 48), 0.0F);
    }
    return film;
}

TEST(Denoise, LeavesAPictureWithoutNoise) {
    Film film = film_with_step(0.0);
    ASSERT_TRUE(denoise(film, own));
    for (std::size_t i = 0; i < film.sum.size(); ++i) {
        ASSERT_NEAR(film.sum[i].r, film.noisy[i].r, 1e-4 * film.noisy[i].r) << i;
    }
}

// The noise of 16 samples falls to half or less, and the edge stays where it is.
TEST(Denoise, FollowsTheEdgesOfFeatures) {
    Film film = film_with_step(1.0);
    ASSERT_TRUE(denoise(film, own));
    double before = 0.0;
    double after = 0.0;
    for (std::size_t i = 0; i < film.sum.size(); ++i) {
        const double level = 16.0 * (i % 48 >= 24 ? 0.8 : 0.2);
        before += std::pow(film.noisy[i].r / level - 1.0, 2.0);
        after += std::pow(film.sum[i].r / level - 1.0, 2.0);
    }
    EXPECT_LT(after, before / 4.0);
    // Four standard errors of the mean of a column, whose samples are from -1 to 1 evenly. Beside
    // the edge, the mean of both sides would be off by 0.375 or more.
    const auto rows = static_cast<double>(film.height);
    for (std::size_t x = 0; x < film.width; ++x) {
        double mean = 0.0;
        for (std::size_t y = 0; y < film.height; ++y) {
            mean += film.sum[film.index(x, y)].r / (16.0 * (x >= 24 ? 0.8 : 0.2)) / rows;
        }
        EXPECT_NEAR(mean, 1.0, 4.0 * std::sqrt(1.0 / 3.0 / 16.0 / rows)) << x;
    }
}

// A bright lamp of which some pixels see only a part: a linear fit by position would fall below
// what is around it.
TEST(Denoise, LeavesNoDarkEdgeAtALamp) {
    Film film = film_with_step(0.0);
    constexpr std::array samples_lit{0, 0, 1, 3, 6, 10, 13};  // Of 16, in neighbouring columns.
    for (std::size_t y = 10; y < 22; ++y) {
        for (std::size_t k = 0; k < samples_lit.size(); ++k) {
            const std::size_t i = film.index(8 + k, y);
            const double bright = samples_lit[k] * 5000.0;
            film.sum[i] += Color4d(bright, bright, bright, 0.0);
            film.sum_of_squares[i] += Color4d(bright, bright, bright, 0.0) * 5000.0;
        }
    }
    ASSERT_TRUE(denoise(film, own));
    for (std::size_t i = 0; i < film.sum.size(); ++i) {
        ASSERT_GE(film.sum[i].r, 16.0 * 0.2 * 0.99) << i;
    }
}

TEST(Denoise, ARegionIsDenoisedByItself) {
    Request wanted = request(width, height, "path", 4);
    wanted.layout.layers = denoise_layers();
    wanted.layout.window = Region{17, 9, 30, 20};
    Film film = render(room(), view(), wanted).film;
    ASSERT_TRUE(denoise(film, own));
    EXPECT_EQ(film.noisy.size(), 600U);
}

TEST(Denoise, ReportsWhatIsMissing) {
    const auto message = [](Film film, const DenoiseOptions& options = own) {
        const auto done = denoise(film, options);
        EXPECT_FALSE(done);
        return to_text(done.diagnostics);
    };
    Film film = film_with_step(0.5);
    film.means.normal.clear();
    EXPECT_NE(message(film).find("mean_normal"), std::string::npos);
    EXPECT_NE(message(*make_film({.width = 4, .height = 4})).find("layer"), std::string::npos);
    film = film_with_step(0.5);
    film.passes[0] = 1;
    EXPECT_NE(message(film).find("two samples"), std::string::npos);
    film = film_with_step(0.5);
    ASSERT_TRUE(denoise(film, own));
    EXPECT_NE(message(film).find("already"), std::string::npos);
    EXPECT_NE(
        message(film_with_step(0.5), {Denoiser::library, "/nowhere/library.so"}).find("not found"),
        std::string::npos);
}

TEST(Denoise, AJobDoesNotContinueADenoisedFilm) {
    const auto shared_film = std::make_shared<Film>(noisy_room());
    Film& film = *shared_film;
    ASSERT_TRUE(denoise(film, own));
    const auto renderer = Renderer::make(std::make_shared<scene::Scene>(room()));
    const auto job = Job::make(*renderer, view(), request(width, height, "path", 64), shared_film);
    ASSERT_FALSE(job);
    EXPECT_NE(to_text(job.diagnostics).find("denoised"), std::string::npos);
}

TEST(Denoise, FindsDenoisersByName) {
    for (const std::string& name : denoisers().all()) {
        EXPECT_TRUE(denoisers().find(name)) << name;
    }
    EXPECT_EQ(denoisers().find("features"), Denoiser::features);
    EXPECT_FALSE(denoisers().find("oidn"));
}

// -------------------------------------------------------------------- a library of the machine

// A library with the functions of Open Image Denoise, whose filter halves the colour.
const DenoiseOptions with_library{.denoiser = Denoiser::automatic,
                                  .library = BALCONY_DENOISE_LIBRARY};

TEST(DenoiseLibrary, IsUsedWhereThereIsOne) {
    Film film = film_with_step(0.5);
    const auto done = denoise(film, with_library);
    ASSERT_TRUE(done && done.diagnostics.empty()) << to_text(done.diagnostics);
    EXPECT_EQ(done->used, BALCONY_DENOISE_LIBRARY);
    for (std::size_t i = 0; i < film.sum.size(); ++i) {
        ASSERT_NEAR(film.sum[i].g, 0.5 * film.noisy[i].g, 1e-5 * film.noisy[i].g);
    }
}

// The library refuses pictures of 13 pixels width.
TEST(DenoiseLibrary, WhatItReportsIsAWarningAndTheOtherFilterIsUsed) {
    Film film = *make_film({.width = 13, .height = 4, .layers = denoise_layers()});
    film.passes.assign(film.tile_count(), 2);
    Film same = film;
    const auto done = denoise(film, with_library);
    ASSERT_TRUE(done);
    EXPECT_NE(done->used, BALCONY_DENOISE_LIBRARY);
    EXPECT_NE(to_text(done.diagnostics).find("13 is unlucky"), std::string::npos);
    const auto required = denoise(same, {Denoiser::library, BALCONY_DENOISE_LIBRARY});
    EXPECT_TRUE(!required && has_errors(required.diagnostics));
}

TEST(DenoiseLibrary, AFileWithOtherFunctionsIsNone) {
    Film film = film_with_step(0.5);
    const auto done = denoise(film, {Denoiser::automatic, "libm.so.6"});
    ASSERT_TRUE(done);
    EXPECT_EQ(done->used, "Balcony's filter");
}

}  // namespace
}  // namespace balcony::render::test::denoise_test
