// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Paths of neighbouring pixels that share what they find, against independent paths.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "render/sampling/pixel_groups.hpp"
#include "support.hpp"

namespace balcony::render::path_reuse_test {

namespace {

using namespace test;

scene::Material of_color(const Color3f& color, float roughness = 1.0F) {
    scene::Material material = white();
    material.base_color = color;
    material.roughness = roughness;
    return material;
}

// A closed room of 2 x 2 x 2.5 with a lamp below its ceiling.
scene::Scene matt_room() {
    scene::Scene scene;
    const Color3f grey(0.7F);
    const Color3f red(0.6F, 0.1F, 0.1F);
    add(scene, parallelogram({-1, -1, 1.5F}, {2, 0, 0}, {0, 0, -2.5F}), of_color(grey));
    add(scene, parallelogram({-1, 1, -1}, {2, 0, 0}, {0, 0, 2.5F}), of_color(grey));
    add(scene, parallelogram({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}), of_color(grey));
    add(scene, parallelogram({-1, -1, 1.5F}, {0, 0, -2.5F}, {0, 2, 0}), of_color(red));
    add(scene, parallelogram({1, -1, -1}, {0, 0, 2.5F}, {0, 2, 0}), of_color(grey));
    add(scene, parallelogram({1, -1, 1.5F}, {-2, 0, 0}, {0, 2, 0}), of_color(grey));
    scene::Material lamp = of_color(Color3f(0.0F));
    lamp.emission = Color3f(8.0F);
    add(scene, parallelogram({-0.3F, 0.9F, -0.3F}, {0.6F, 0, 0}, {0, 0, 0.6F}), lamp);
    return scene;
}

// The same with all that makes heads and tails differ: a glossy floor, a screen that hides a part
// of the room, a varnished wall, a mirror, a coat, glass, a veil, and a sphere whose normals are
// bent.
scene::Scene full_room() {
    scene::Scene scene = matt_room();
    scene.materials[0].roughness = 0.25F;
    scene.materials[2].roughness = 0.0F;
    scene.materials[2].ior = 2.5F;
    add(scene, parallelogram({-0.6F, -1, -0.5F}, {0.5F, 0, 0.4F}, {0, 0.9F, 0}),
        of_color(Color3f(0.2F, 0.5F, 0.2F), 0.5F));
    scene::Material mirror = of_color(Color3f(0.9F), 0.0F);
    mirror.metallic = 1.0F;
    add(scene, parallelogram({0.98F, -0.8F, -0.8F}, {0, 0, 1.0F}, {0, 1.2F, 0}), mirror);
    scene::Material coated = of_color(Color3f(0.3F, 0.3F, 0.7F), 0.8F);
    coated.clearcoat = 1.0F;
    coated.clearcoat_roughness = 0.3F;
    add(scene, parallelogram({-0.97F, -0.9F, 0.8F}, {0, 0, -0.9F}, {0, 0.8F, 0}), coated);
    scene::Material veil = of_color(Color3f(0.8F));
    veil.alpha_mode = scene::AlphaMode::blend;
    veil.alpha = 0.4F;
    add(scene, parallelogram({-0.2F, -0.9F, 0.1F}, {0.9F, 0, 0.2F}, {0, 0.9F, 0.1F}), veil);
    scene::Material glass = of_color(Color3f(1.0F), 0.3F);
    glass.transmission = 1.0F;
    add(scene, parallelogram({0.1F, -0.95F, -0.4F}, {0.5F, 0, 0.3F}, {0, 0.5F, 0}), glass);
    scene::M44d placed;
    placed.translate(V3d(0.45, -0.6, -0.3));
    add(scene, coarse_sphere(0.3F, 10, 6), of_color(Color3f(0.8F), 0.6F), placed);
    return scene;
}

// The room with a floor of eight strips, every second one of rough metal, whose facets often
// reflect a ray into the surface, where it ends.
scene::Scene strips() {
    scene::Scene scene = matt_room();
    for (int strip = 0; strip < 8; ++strip) {
        const float left = -1.0F + 0.25F * static_cast<float>(strip);
        scene::Material material = of_color(Color3f(0.9F));
        material.metallic = strip % 2 == 0 ? 0.0F : 1.0F;
        add(scene, parallelogram({left, -0.99F, 1}, {0.25F, 0, 0}, {0, 0, -2}), material);
    }
    return scene;
}

// Eight lanes on a floor between black and white walls under a lamp: what is seen from one lane is
// hidden from the next.
scene::Scene lanes() {
    scene::Scene scene;
    add(scene, parallelogram({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), of_color(Color3f(0.8F)));
    for (int lane = 0; lane < 8; ++lane) {
        const float left = -1.0F + 0.25F * static_cast<float>(lane);
        const scene::Material paint = of_color(Color3f(lane % 2 == 0 ? 0.9F : 0.02F));
        add(scene, parallelogram({left + 0.01F, -1, 0}, {0, 2, 0}, {0, 0, 0.4F}), paint);
        add(scene, parallelogram({left + 0.24F, -1, 0}, {0, 2, 0}, {0, 0, 0.4F}), paint);
    }
    scene::Material lamp = of_color(Color3f(0.0F));
    lamp.emission = Color3f(3.0F);
    add(scene, parallelogram({-1, -1, 1.5F}, {0, 2, 0}, {2, 0, 0}), lamp);
    return scene;
}

// Which part of the picture a pixel belongs to.
using PartOf = std::size_t (*)(std::size_t x, std::size_t y);
constexpr std::size_t side = 16;
std::size_t quarter(std::size_t x, std::size_t y) { return x / 8 + y / 8 * 2; }
std::size_t lane_color(std::size_t x, std::size_t /*y*/) { return x / 2 % 2; }

// The means over the parts of a picture, and their standard errors by independent pictures.
struct Means {
    std::array<double, 4> mean{};
    std::array<double, 4> error{};
};

Means means(const scene::Scene& scene, const camera::Camera& camera, PartOf part, bool reuse,
            std::size_t samples) {
    constexpr std::size_t pictures = 12;
    std::array<double, 4> sum{};
    std::array<double, 4> squares{};
    for (std::size_t seed = 0; seed < pictures; ++seed) {
        Request asked = request(side, side, "path", samples);
        asked.path.reuse = reuse;
        asked.sampling.seed = static_cast<std::uint32_t>(seed + (reuse ? 100 : 0));
        const Film film = render(scene, camera, asked).film;
        std::array<double, 4> light{};
        for (std::size_t y = 0; y < side; ++y) {
            for (std::size_t x = 0; x < side; ++x) {
                light[part(x, y)] += film.pixel(x, y).g;
            }
        }
        for (std::size_t i = 0; i < light.size(); ++i) {
            sum[i] += light[i];
            squares[i] += light[i] * light[i];
        }
    }
    Means found;
    for (std::size_t i = 0; i < sum.size(); ++i) {
        const double mean = sum[i] / pictures;
        const double variance = (squares[i] / pictures - mean * mean) / (pictures - 1);
        found.mean[i] = mean;
        found.error[i] = std::sqrt(std::max(variance, 0.0));
    }
    return found;
}

// Four standard errors, as estimated from twelve pictures each: the seeds are fixed, so that chance
// has been met once and for all.
void expect_equal_means(const scene::Scene& scene, const camera::Camera& camera, PartOf part) {
    const Means found = means(scene, camera, part, true, 256);
    const Means expected = means(scene, camera, part, false, 256);
    for (std::size_t i = 0; i < found.mean.size(); ++i) {
        const double error = std::hypot(found.error[i], expected.error[i]);
        EXPECT_LE(error, 0.01 * expected.mean[i]) << "no power";
        EXPECT_LE(std::abs(found.mean[i] - expected.mean[i]), 4.0 * error) << "part " << i;
    }
}

TEST(PathReuse, HasTheMeanOfIndependentPaths) {
    const camera::Camera inside = pinhole(view_down_z(0.1, 0.05, 1.4));
    const camera::Camera down = orthographic({{0, 0, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}});
    expect_equal_means(strips(), down, lane_color);
    expect_equal_means(full_room(), inside, quarter);
    const camera::Camera above = orthographic(view_down_z(0.0, 0.0, 1.0));
    expect_equal_means(lanes(), above, lane_color);
}

TEST(PathReuse, HasLessNoise) {
    const camera::Camera camera = pinhole(view_down_z(0.1, 0.05, 1.4));
    const auto noise = [&](bool reuse) {
        Request asked = request(32, 32, "path", 64);
        asked.path.reuse = reuse;
        asked.layout.second_moment = true;
        const Film film = render(matt_room(), camera, asked).film;
        double variance = 0.0;
        // Below the lamp, whose border is noisy with either.
        for (std::size_t i = film.sum.size() / 2; i < film.sum.size(); ++i) {
            variance += film.variance(i % film.width, i / film.width).g;
        }
        return variance;
    };
    // A group of eight could have an eighth of the variance, if all light were indirect.
    EXPECT_LT(noise(true), 0.4 * noise(false));
}

// A pixel without neighbours: its own path finds the light with its own density alone.
TEST(PathReuse, OfOnePixelIsThatOfItsPath) {
    const camera::Camera camera = pinhole(view_down_z(0.1, 0.05, 1.4));
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const auto rendered = [&](bool reuse) {
            Request asked = request(1, 1, "path", 1);
            asked.path.reuse = reuse;
            asked.sampling.seed = seed;
            return render(full_room(), camera, asked).film.pixel(0, 0);
        };
        const double expected = rendered(false).g;
        // The direction to the tail is found again from rounded points.
        EXPECT_NEAR(rendered(true).g, expected, 1e-4 * expected) << seed;
    }
}

TEST(PathReuse, KeepsTheLimitOfIndirectLight) {
    const camera::Camera camera = pinhole(view_down_z(0.1, 0.05, 1.4));
    const auto rendered = [&](float limit) {
        Request asked = request(16, 16, "path", 1);
        asked.path.clamp_indirect = limit;
        return render(matt_room(), camera, asked).film;
    };
    const Film free = rendered(0.0F);
    const Film limited = rendered(0.05F);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < free.sum.size(); ++i) {
        EXPECT_LE(limited.sum[i].g, free.sum[i].g * 1.0001);
        changed += limited.sum[i].g < 0.9 * free.sum[i].g ? 1 : 0;
    }
    EXPECT_GT(changed, free.sum.size() / 4);
}

TEST(PixelGroups, SpreadOverABlockAndChangeFromPassToPass) {
    const Region region{64, 32, 64, 32};
    std::set<std::vector<std::uint32_t>> patterns;
    for (std::size_t pass = 0; pass < 8; ++pass) {
        const PixelGroups groups(region, pass);
        std::map<std::uint32_t, std::vector<std::array<std::size_t, 2>>> pixels;
        std::vector<std::uint32_t> pattern;
        for (std::size_t y = 32; y < 64; ++y) {
            for (std::size_t x = 64; x < 128; ++x) {
                pixels[groups.of(x, y)].push_back({x, y});
                pattern.push_back(groups.of(x, y));
            }
        }
        EXPECT_EQ(pixels.size(), 64 * 32 / PixelGroups::size);
        for (const auto& [group, members] : pixels) {
            ASSERT_EQ(members.size(), PixelGroups::size);
            std::set<std::array<std::size_t, 2>> blocks;
            std::set<std::array<std::size_t, 2>> wide;
            std::set<std::array<std::size_t, 2>> high;
            for (const auto& [x, y] : members) {
                blocks.insert({x / PixelGroups::block_side, y / PixelGroups::block_side});
                wide.insert({x / 8, y / 4});
                high.insert({x / 4, y / 8});
            }
            EXPECT_EQ(blocks.size(), 1U);
            EXPECT_EQ(std::max(wide.size(), high.size()), PixelGroups::size);
        }
        patterns.insert(pattern);
    }
    EXPECT_EQ(patterns.size(), 8U);
}

// A part of the picture has the groups of the whole, apart from its borders.
TEST(PixelGroups, AreThoseOfThePicture) {
    const PixelGroups whole({0, 0, 64, 32}, 3);
    const PixelGroups part({16, 4, 28, 12}, 3);
    for (std::size_t y = 4; y < 16; ++y) {
        for (std::size_t x = 16; x < 44; ++x) {
            for (std::size_t other = 16; other < 44; ++other) {
                EXPECT_EQ(whole.of(x, y) == whole.of(other, y), part.of(x, y) == part.of(other, y));
            }
        }
    }
}

}  // namespace

}  // namespace balcony::render::path_reuse_test
