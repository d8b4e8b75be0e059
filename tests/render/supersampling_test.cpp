// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Pixels at lamps' borders and at glass, which take four samples in a pass.

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "film/sums/tile_image.hpp"
#include "support.hpp"

namespace balcony::render::supersampling_test {

namespace {

using namespace test;

constexpr std::size_t side = 40;

// A black lamp: all that is seen of it is its own light.
scene::Material lamp(float emission) {
    scene::Material material = white();
    material.base_color = Color3f(0.0F);
    material.emission = Color3f(emission);
    return material;
}

scene::Material glass() {
    scene::Material material = white();
    material.roughness = 0.0F;
    material.transmission = 1.0F;
    material.thin_walled = false;
    return material;
}

// A slanted lamp in the dark.
scene::Scene lamp_in_the_dark() {
    scene::Scene scene;
    add(scene, parallelogram({-0.5F, -0.4F, 0}, {0.9F, 0.25F, 0}, {-0.2F, 0.7F, 0}), lamp(6.0F));
    return scene;
}

// Also a ball of glass and a wall that they light.
scene::Scene lamp_and_glass() {
    scene::Scene scene = lamp_in_the_dark();
    scene::M44d placed;
    placed.translate(V3d(0.5, 0.5, 0.5));
    add(scene, coarse_sphere(0.4F, 24, 12), glass(), placed);
    add(scene, wall(-1.0F, 3.0F), white());
    return scene;
}

Request with_box(std::string integrator, std::size_t samples) {
    Request asked = request(side, side, std::move(integrator), samples);
    asked.sampling.filter = "box";
    asked.layout.layers = LayerSet{LayerId::emission};
    return asked;
}

const camera::Camera ahead = orthographic(view_down_z(0.0, 0.0, 2.0));

// The samples are those of so many passes: `direct`, which takes one in a pass, finds the same
// light at the border with four times as many.
void expect_more_passes(const scene::Scene& scene) {
    constexpr std::size_t passes = 4;
    const Film found = render(scene, ahead, with_box("path", passes)).film;
    const Film same = render(scene, ahead, with_box("direct", passes)).film;
    const Film more = render(scene, ahead, with_box("direct", 4 * passes)).film;
    std::size_t border = 0;
    std::size_t improved = 0;
    for (std::size_t i = 0; i < found.sum.size(); ++i) {
        const double expected = more.sum[i].g / 4.0;
        EXPECT_NEAR(found.sum[i].g, expected, 1e-5 * expected) << i;
        EXPECT_NEAR(found.sum[i].a, more.sum[i].a / 4.0, 1e-5) << i;
        EXPECT_NEAR(found.means.emission[i].y, more.means.emission[i].y / 4.0, 1e-5 * expected)
            << i;
        border += expected > 0.0 && expected < 6.0 * passes ? 1 : 0;
        improved += std::abs(same.sum[i].g - expected) > 1e-3 ? 1 : 0;
    }
    EXPECT_GT(border, side);
    EXPECT_GT(improved, border / 2);
}

TEST(Supersampling, AtLampsIsAsIfTheyHadMorePasses) { expect_more_passes(lamp_in_the_dark()); }

TEST(Supersampling, AtLampsBehindAPaneIsAsIfTheyHadMorePasses) {
    scene::Scene scene = lamp_in_the_dark();
    scene::Material pane = glass();
    pane.thin_walled = true;
    pane.specular = 0.0F;  // So that no chance decides what passes it.
    add(scene, wall(0.5F, 3.0F), pane);
    expect_more_passes(scene);
}

// As glass neither adds light nor takes it, and all samples of a pixel have the same weight, a slab
// of it in even light is invisible.
TEST(Supersampling, AtGlassKeepsTheMean) {
    scene::Scene scene;
    add(scene, parallelogram({-0.5F, -0.5F, 0.2F}, {1, 0, 0}, {0, 1, 0}), glass());
    add(scene, parallelogram({0.5F, -0.5F, -0.2F}, {-1, 0, 0}, {0, 1, 0}), glass());
    constexpr std::size_t passes = 16;
    Request asked = with_box("path", passes);
    asked.ambient = Color3f(1.0F);
    const Film film = render(scene, ahead, asked).film;
    for (std::size_t i = 0; i < film.sum.size(); ++i) {
        EXPECT_NEAR(film.sum[i].g / passes, 1.0, 1e-4) << i;
        EXPECT_NEAR(film.sum[i].a / passes, 1.0, 1e-6) << i;
    }
}

TEST(Supersampling, CountsEachPixelOnce) {
    const Rendered found = render(lamp_and_glass(), ahead, with_box("path", 3));
    EXPECT_EQ(found.summary.camera_rays, 3 * side * side);
    EXPECT_EQ(found.summary.invalid_pixels, 0U);
    EXPECT_EQ(found.film.samples(side / 2, side / 2), 3U);
}

// Which pixels they are does not depend on threads, the window, or where a job begins.
TEST(Supersampling, IsTheSameInPartsOfAPicture) {
    Request asked = with_box("path", 3);
    asked.threads = 1;
    const Film whole = render(lamp_and_glass(), ahead, asked).film;
    asked.threads = 2;
    asked.layout.window = Region{9, 5, 24, 26};
    const Film part = render(lamp_and_glass(), ahead, asked).film;
    for_each_pixel(part.window, [&](std::size_t i, std::size_t x, std::size_t y) {
        EXPECT_EQ(part.sum[i], whole.sum[whole.index(x, y)]) << x << ' ' << y;
        EXPECT_EQ(part.means.emission[i], whole.means.emission[whole.index(x, y)]);
    });
    asked.layout.window.reset();
    Film total = *make_film(asked.layout);
    const Renderer renderer = renderer_of(lamp_and_glass());
    asked.samples = 2;
    ASSERT_TRUE(render::render(renderer, ahead, asked, total));
    asked.samples = 3;
    ASSERT_TRUE(render::render(renderer, ahead, asked, total));
    EXPECT_EQ(total.sum, whole.sum);
    Film last = *make_film(asked.layout);
    last.first_pass = 2;
    asked.samples = 1;
    Film first = *make_film(asked.layout);
    ASSERT_TRUE(render::render(renderer, ahead, asked, last));
    asked.samples = 2;
    ASSERT_TRUE(render::render(renderer, ahead, asked, first));
    for (std::size_t i = 0; i < whole.sum.size(); ++i) {
        EXPECT_EQ(first.sum[i] + last.sum[i], whole.sum[i]) << i;
    }
}

}  // namespace

}  // namespace balcony::render::supersampling_test
