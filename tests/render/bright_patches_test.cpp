// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Paths that are sent to the brightest parts of surfaces, against others.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "directions.hpp"
#include "render/job/point_boxes.hpp"
#include "render/tracing/bright_patches.hpp"
#include "statistics.hpp"
#include "support.hpp"

namespace balcony::render::test::bright_patches_test {
namespace {

// A flat box, a thick one, and one that nobody sees.
BrightPatches three_boxes() {
    const std::vector<BrightBox> boxes{{{-2.0F, -1.1F, -1.0F}, {2.0F, -1.0F, 0.5F}, 2.0F},
                                       {{0.5F, 0.5F, 1.0F}, {1.5F, 2.5F, 2.0F}, 1.0F},
                                       {{5.0F, 5.0F, 5.0F}, {6.0F, 6.0F, 6.0F}, 1.0F}};
    return {boxes, {{V3f(0.0F), 0.5F, LaneFloats{0.3F, 0.2F, 0.0F}}}};
}

TEST(BrightPatches, DirectionsHaveTheirDensity) {
    constexpr int draws = 50'000;
    const BrightPatches patches = three_boxes();
    const BrightPatches::Place* const place = patches.at(V3f(0.0F));
    ASSERT_NE(place, nullptr);
    Random random(1);
    // The last two are in a box and below all.
    for (const V3f& from :
         {V3f(0.0F), V3f(3.0F, 0.0F, 0.2F), V3f(1.0F, 1.2F, 1.3F), V3f(0.2F, -3.0F, 0.0F)}) {
        std::vector<double> expected = SphereCells::integrals(
            [&](const V3f& direction) { return patches.pdf(*place, from, direction); }, 24);
        EXPECT_NEAR(sum(expected), 1.0, 0.01) << from;
        const double factor = draws / sum(expected);
        for (double& one : expected) {
            one *= factor;
        }
        std::vector<double> counts(expected.size());
        for (int i = 0; i < draws; ++i) {
            counts[SphereCells::cell_of(patches.sample(*place, from, random.numbers()))] += 1.0;
        }
        EXPECT_GT(chi_square_probability(counts, expected), significance) << from;
    }
}

// 2 and 1 of the boxes, and 0.5 of the rest: 3 of 3.5, of which a path is sent at most 0.6.
TEST(BrightPatches, AreSoughtByWhatTheyAddToTheLight) {
    const BrightPatches patches = three_boxes();
    const BrightPatches::Place* const place = patches.at(V3f(9.0F));
    ASSERT_NE(place, nullptr);
    EXPECT_FLOAT_EQ(place->share, 0.6F);
    EXPECT_FLOAT_EQ(place->cumulative[0], 2.0F / 3.0F);
    EXPECT_FLOAT_EQ(place->cumulative[1], 1.0F);
    const std::vector<BrightBox> box{{V3f(1.0F), V3f(2.0F), 1.0F}};
    EXPECT_FLOAT_EQ(BrightPatches(box, {{V3f(0.0F), 3.0F, LaneFloats{0.1F}}}).at(V3f(0.0F))->share,
                    0.25F);
    EXPECT_EQ(BrightPatches(box, {{V3f(0.0F), 30.0F, LaneFloats{0.1F}}}).at(V3f(0.0F)), nullptr);
}

TEST(PointBoxes, OfSurfacesThatFaceAxesAreFlat) {
    Random random(2);
    std::vector<BrightPoint> points;
    for (int i = 0; i < 100; ++i) {
        const Imath::V2f at = random.pair();
        points.push_back({{at.x, 0.0F, at.y}, {0.0F, 1.0F, 0.0F}});
        points.push_back({{at.y, at.x, 0.0F}, {0.0F, 0.0F, 1.0F}});
    }
    std::size_t count = 0;
    for (const PointBox& box : point_boxes(points, 16)) {
        const V3f sides = box.high - box.low;
        EXPECT_EQ(std::min(sides.y, sides.z), 0.0F);
        EXPECT_GE(box.points.size(), 8U);
        count += box.points.size();
    }
    EXPECT_EQ(count, points.size());
    EXPECT_EQ(point_boxes(points, 3).size(), 3U);
    EXPECT_EQ(point_boxes({points.begin(), points.begin() + 15}, 16).size(), 1U);
}

scene::Material paint(float albedo, float roughness = 1.0F) {
    scene::Material material = white();
    material.base_color = Color3f(albedo);
    material.roughness = roughness;
    return material;
}

// A closed room of side 2 with a glossy floor, a screen, a pane and a square lamp at the ceiling.
scene::Scene room(float lamp_side = 1.0F) {
    scene::Scene scene;
    const V3f x(2.0F, 0.0F, 0.0F);
    const V3f y(0.0F, 2.0F, 0.0F);
    const V3f z(0.0F, 0.0F, 2.0F);
    const V3f low(-1.0F);
    add(scene, parallelogram(low, x, z), paint(0.6F, 0.35F));
    for (const auto& [corner, right, up] :
         {std::array{low + y, x, z}, std::array{low, x, y}, std::array{low + z, x, y},
          std::array{low, y, z}, std::array{low + x, y, z}}) {
        add(scene, parallelogram(corner, right, up), paint(0.6F));
    }
    add(scene, parallelogram({-0.7F, -1.0F, -0.3F}, {0.4F, 0.0F, 0.5F}, {0.0F, 0.8F, 0.0F}),
        paint(0.4F));
    scene::Material pane = paint(1.0F, 0.0F);
    pane.transmission = 1.0F;
    add(scene, parallelogram({0.3F, -0.9F, -0.5F}, {0.0F, 0.0F, 0.8F}, {0.0F, 0.7F, 0.0F}), pane);
    scene::Material lamp = paint(0.0F);
    lamp.emission = Color3f(0.2F);
    add(scene,
        parallelogram({-lamp_side / 2.0F, 0.99F, -lamp_side / 2.0F}, {lamp_side, 0.0F, 0.0F},
                      {0.0F, 0.0F, lamp_side}),
        lamp);
    return scene;
}

// With a spot of light on the floor.
scene::Scene room_with_spot(float lamp_side = 1.0F) {
    scene::Scene scene = room(lamp_side);
    scene::Light spot;
    spot.kind = scene::LightKind::spot;
    spot.position = V3d(0.3, 0.9, 0.2);
    spot.direction = V3d(0.1, -1.0, 0.1);
    spot.inner_cone = 0.19F;
    spot.outer_cone = 0.2F;
    spot.intensity = Color3f(20.0F);
    scene.lights = {spot};
    return scene;
}

Rendered picture_of(const scene::Scene& scene, const Request& asked) {
    return render(scene, pinhole(view_down_z(0.1, 0.0, 0.9)), asked);
}

constexpr std::size_t side = 24;

Request request_of(bool patches, bool reuse, std::size_t samples, std::uint32_t seed = 0) {
    Request asked = request(side, side, "path", samples);
    asked.path.probes_patches = patches;
    asked.path.reuse = reuse;
    asked.sampling.seed = seed;
    return asked;
}

// Of the light in quarters of pictures with several seeds.
struct Light {
    std::array<double, 4> mean{};
    std::array<double, 4> error{};  // Of the mean.
};

Light light_of(bool patches, bool reuse) {
    constexpr std::size_t pictures = 16;
    // So wide that surfaces and lamps both find it often, which their weights are to be right for.
    constexpr float wide = 1.8F;
    const scene::Scene scene = room_with_spot(wide);
    std::array<double, 4> squares{};
    Light light;
    for (std::uint32_t seed = 0; seed < pictures; ++seed) {
        const std::size_t samples = patches ? 64 : 192;  // They are noisier.
        const Film film = picture_of(scene, request_of(patches, reuse, samples, seed)).film;
        std::array<double, 4> sums{};
        for (std::size_t i = 0; i < film.sum.size(); ++i) {
            sums[i % side / (side / 2) + i / side / (side / 2) * 2] +=
                film.sum[i].g / static_cast<double>(samples);
        }
        for (std::size_t i = 0; i < sums.size(); ++i) {
            light.mean[i] += sums[i] / pictures;
            squares[i] += sums[i] * sums[i] / pictures;
        }
    }
    for (std::size_t i = 0; i < squares.size(); ++i) {
        light.error[i] = std::sqrt((squares[i] - light.mean[i] * light.mean[i]) / (pictures - 1));
    }
    return light;
}

TEST(BrightPatches, KeepTheMean) {
    for (const bool reuse : {false, true}) {
        const Light expected = light_of(false, reuse);
        const Light found = light_of(true, reuse);
        for (std::size_t i = 0; i < found.mean.size(); ++i) {
            const double error = std::hypot(found.error[i], expected.error[i]);
            EXPECT_LT(error, 0.01 * expected.mean[i]) << "no power";
            EXPECT_NEAR(found.mean[i], expected.mean[i], 4.0 * error) << reuse << ' ' << i;
        }
    }
}

TEST(BrightPatches, TakeMostOfTheNoise) {
    const scene::Scene scene = room_with_spot();
    for (const bool reuse : {false, true}) {
        const auto noise = [&](bool patches) {
            Request asked = request_of(patches, reuse, 64);
            asked.layout.second_moment = true;
            const Film film = picture_of(scene, asked).film;
            double variance = 0.0;
            for (std::size_t i = 0; i < film.sum.size() / 2; ++i) {
                variance += film.variance(i % side, i / side).g;
            }
            return variance;
        };
        EXPECT_LT(noise(true), 0.4 * noise(false)) << reuse;
    }
}

TEST(BrightPatches, ChangeNothingWhereThereAreNone) {
    const scene::Scene scene = room();
    EXPECT_EQ(picture_of(scene, request_of(true, true, 4)).film.sum,
              picture_of(scene, request_of(false, true, 4)).film.sum);
}

// They are those of the whole picture, for any number of threads, and later samples.
TEST(BrightPatches, PartsHaveTheLightOfTheWhole) {
    const scene::Scene scene = room_with_spot();
    Request asked = request_of(true, true, 4);
    const Film whole = picture_of(scene, asked).film;
    EXPECT_NE(whole.sum, picture_of(scene, request_of(false, true, 4)).film.sum);
    asked.threads = 1;
    EXPECT_EQ(picture_of(scene, asked).film.sum, whole.sum);
    asked.layout.window = Region{7, 5, 11, 9};
    const Film part = picture_of(scene, asked).film;
    for (std::size_t y = 5; y < 14; ++y) {
        for (std::size_t x = 7; x < 18; ++x) {
            ASSERT_EQ(part.pixel(x, y), whole.pixel(x, y)) << x << ' ' << y;
        }
    }
}

}  // namespace
}  // namespace balcony::render::test::bright_patches_test
