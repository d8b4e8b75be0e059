// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Denoising: what it removes, what it keeps, and what it refuses.

#include "balcony/denoise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "film/sums/tile_image.hpp"
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

// Of the means over boxes of side x side pixels, as a display shows them, with a gamma of 2.2 and
// up to 1: the lamp alone would otherwise count more than the room.
double error_of(const Film& film, const Film& reference, std::size_t side = 1) {
    const auto box = [side](const Film& of, std::size_t x, std::size_t y) {
        V3d sum(0.0);
        for_each_pixel({x, y, side, side}, [&](std::size_t, std::size_t px, std::size_t py) {
            const Color4f light = of.pixel(px, py);
            sum += V3d(light.r, light.g, light.b);
        });
        return sum / static_cast<double>(side * side);
    };
    double squares = 0.0;
    double count = 0.0;
    for (std::size_t y = 0; y + side <= height; y += side) {
        for (std::size_t x = 0; x + side <= width; x += side) {
            const V3d a = box(film, x, y);
            const V3d b = box(reference, x, y);
            for (int c = 0; c < 3; ++c) {
                const auto shown = [](double light) {
                    return std::pow(std::clamp(light, 0.0, 1.0), 1.0 / 2.2);
                };
                squares += std::pow(shown(a[c]) - shown(b[c]), 2.0);
                count += 1.0;
            }
        }
    }
    return std::sqrt(squares / count);
}

const DenoiseOptions own{.denoiser = Denoiser::features};

// Large enough that the noise of the reference, a quarter of that of 32 samples, hardly counts.
const Film& clean_room() {
    static const Film film = rendered(512);
    return film;
}

// The error falls to less than half, and no mean over a part of the picture gets worse.
TEST(Denoise, MakesARoomBetterAtEveryScale) {
    for (const bool reuse : {false, true}) {
        const Film noisy = reuse ? noisy_room() : rendered(32, false);
        Film film = noisy;
        const auto done = denoise(film, own);
        ASSERT_TRUE(done) << to_text(done.diagnostics);
        EXPECT_LT(error_of(film, clean_room()), 0.5 * error_of(noisy, clean_room()));
        for (const std::size_t side : {1U, 2U, 4U, 8U, 16U}) {
            const double before = error_of(noisy, clean_room(), side);
            const double after = error_of(film, clean_room(), side);
            std::cout << (reuse ? "with" : "without") << " path reuse, boxes of " << side << ": "
                      << before << " -> " << after << '\n';
            EXPECT_LE(after, before) << side;
        }
    }
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
}

// Adds light that a surface reflects to a pixel of a film, as the sample with a number.
void add_direct(Film& film, std::size_t i, double light, int sample) {
    film.sum[i] += Color4d(light, light, light, 0.0);
    film.means.direct[i] += V3d(light);
    if (sample < 8) {  // Of 16.
        film.means.direct_half[i].first += V3f(static_cast<float>(light));
    }
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
            add_direct(film, i, level * (1.0 + noise * random()), sample);
        }
        film.sum[i].a = 16.0;
        film.means.albedo[i].mean = V3f(right ? 0.8F : 0.2F);
        film.means.normal[i].mean = V3f(0.0F, 0.0F, 1.0F);
        film.means.position[i].mean =
            V3f(static_cast<float>(i % 48), static_cast<float>(i / 48), 0.0F);
    }
    return film;
}

// One sample of enormous light, in a pixel or, by path reuse, in all of a block, is neither kept
// nor spread. Its light is counted.
//
// A half is the mean of 8 samples from 0.5 to 1.5 of the level: it deviates by 0.10, and means over
// 3 x 3 pixels by 0.034. Let none be further from the level than five times that. A half with an
// outlier is limited to 6 times the brightest of the other half's means nearby, 6 * 1.17 = 7.0
// levels, and the other half is below 1.5. All that the filter shows are means of such pixels, at
// most (7.0 + 1.5) / 2 = 4.25, to which it adds a tenth in the end: 4.7.
TEST(Denoise, ASingleOutlierDoesNotSpread) {
    for (const std::size_t side : {1U, 4U}) {
        Film film = film_with_step(0.5);
        const double light = 16.0 * 1000.0 * 0.2;
        for_each_pixel({12, 8, side, side}, [&](std::size_t, std::size_t x, std::size_t y) {
            add_direct(film, film.index(x, y), light, 4);
        });
        const auto done = denoise(film, own);
        ASSERT_TRUE(done);
        for (std::size_t x = 0; x < 24; ++x) {
            for (std::size_t y = 0; y < film.height; ++y) {
                EXPECT_LT(film.sum[film.index(x, y)].r, 4.7 * 16.0 * 0.2) << x << ' ' << y;
            }
        }
        const double outliers = light * static_cast<double>(side * side);
        const double rest = 16.0 * 0.5 * 48.0 * 32.0;
        EXPECT_NEAR(done->left_out, outliers / (outliers + rest), 0.01);
    }
}

// What all samples of a pixel have found is there, however bright and small.
TEST(Denoise, KeepsABrightPixel) {
    Film film = film_with_step(0.5);
    const std::size_t at = film.index(12, 8);
    for (int sample = 0; sample < 16; ++sample) {
        add_direct(film, at, 1000.0 * 0.2 * (sample % 4 < 2 ? 0.9 : 1.1), sample);
    }
    ASSERT_TRUE(denoise(film, own));
    EXPECT_GT(film.sum[at].r, 0.8 * film.noisy[at].r);
    EXPECT_LT(film.sum[film.index(13, 8)].r, 1.5 * 16.0 * 0.2);
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

// No light appears where no surface is, also beside pixels that show a surface in part.
TEST(Denoise, LeavesTheBackgroundBlack) {
    Film film = film_with_step(0.5);
    for (std::size_t i = 0; i < film.sum.size(); ++i) {
        if (const std::size_t x = i % 48; x >= 40) {
            const double part = x == 40 ? 0.1 : 0.0;
            film.sum[i] *= part;
            film.means.direct[i] *= part;
            for (V3f* value : {&film.means.direct_half[i].first, &film.means.albedo[i].mean,
                               &film.means.normal[i].mean, &film.means.position[i].mean}) {
                *value *= static_cast<float>(part);
            }
        }
    }
    ASSERT_TRUE(denoise(film, own));
    EXPECT_GT(film.sum[film.index(40, 8)].r, 0.0);
    for (std::size_t i = 0; i < film.sum.size(); ++i) {
        ASSERT_TRUE(i % 48 <= 40 || film.sum[i].r == 0.0) << i;
    }
}

// A bright lamp in a mirror, of which some pixels see only a part.
TEST(Denoise, LeavesNoDarkEdgeAtALamp) {
    Film film = film_with_step(0.0);
    constexpr std::array samples_lit{0, 0, 1, 3, 6, 10, 13};  // Of 16, in neighbouring columns.
    for (std::size_t y = 10; y < 22; ++y) {
        for (std::size_t k = 0; k < samples_lit.size(); ++k) {
            const std::size_t i = film.index(8 + k, y);
            for (int lit = 0; lit < samples_lit[k]; ++lit) {
                add_direct(film, i, 5000.0, lit * 16 / samples_lit[k]);
            }
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
