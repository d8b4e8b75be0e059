// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Textures whose texels are not interpolated.

#include <array>
#include <random>

#include <gtest/gtest.h>

#include "shading/textures/texture_library.hpp"
#include "support.hpp"

namespace balcony::render::test::nearest_texture_test {
namespace {

using Imath::Color4f;
using scene::Wrap;

constexpr std::array<std::size_t, 2> memories{default_texture_memory, 0};  // The second: a file.

scene::Scene with_image(int width, int height, const Pixels& pixels, Wrap wrap) {
    scene::Scene scene;
    scene::Material material = white();
    material.roughness_texture.index = add_texture(scene, encode_png(width, height, 3, pixels));
    scene.textures[0].wrap_u = scene.textures[0].wrap_v = wrap;
    scene.textures[0].interpolated = false;
    add(scene, wall(0.0F, 1.0F), material);
    return scene;
}

// Black on the left, white on the right.
scene::Scene two_texels() {
    return with_image(
        2, 1, [](int x, int) { return std::vector<std::uint8_t>(3, x == 0 ? 0 : 255); },
        Wrap::clamp);
}

float red(const TextureLibrary& library, const TextureFootprint& at) {
    return library.look_up(scene::TextureIndex(0), TextureEncoding::linear, at).r;
}

TEST(NearestTexture, MagnifiedTexelsHaveSharpBorders) {
    const scene::Scene scene = two_texels();
    for (const std::size_t memory : memories) {
        Diagnostics warnings;
        const TextureLibrary library(scene, memory, warnings);
        for (int i = 0; i < 8; ++i) {
            const float u = (static_cast<float>(i) + 0.5F) / 8.0F;
            EXPECT_EQ(red(library, {{u, 0.5F}, {0.125F, 0.0F}, {0.0F, 0.125F}}),
                      i < 4 ? 0.0F : 1.0F)
                << i;
        }
    }
}

TEST(NearestTexture, AWideFootprintIsTheMean) {
    const scene::Scene scene = two_texels();
    Diagnostics warnings;
    const TextureLibrary library(scene, memories[0], warnings);
    // Half a code: the texel of the last level is rounded.
    EXPECT_NEAR(red(library, {{0.1F, 0.5F}, {4.0F, 0.0F}, {0.0F, 4.0F}}), 0.5F, 0.5F / 255.0F);
}

TEST(NearestTexture, TheRaysOfAPacketFindTheSameBits) {
    std::mt19937 random(7);
    const auto noise = [&](int, int) {
        const auto channel = [&] { return static_cast<std::uint8_t>(random() % 256); };
        return std::vector<std::uint8_t>{channel(), channel(), channel()};
    };
    std::uniform_real_distribution<float> place(-2.0F, 3.0F);
    std::uniform_real_distribution<float> change(-0.08F, 0.08F);
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
        const scene::Scene scene = with_image(37, 21, noise, wrap);
        for (const std::size_t memory : memories) {
            Diagnostics warnings;
            const TextureLibrary library(scene, memory, warnings);
            for (int trial = 0; trial < 200; ++trial) {
                texture_lanes::Footprints asked;
                std::array<Color4f, lane_count> expected;
                for (std::size_t lane = 0; lane < expected.size(); ++lane) {
                    // Some within a texel, others across many.
                    const float scale = lane % 2 == 0 ? 0.1F : 1.0F;
                    const TextureFootprint one{{place(random), place(random)},
                                               {scale * change(random), scale * change(random)},
                                               {scale * change(random), scale * change(random)}};
                    asked.at.set(lane, one.at);
                    asked.along_x.set(lane, one.along_x);
                    asked.along_y.set(lane, one.along_y);
                    expected[lane] =
                        library.look_up(scene::TextureIndex(0), TextureEncoding::linear, one);
                }
                LaneVectors found;
                library.look_up(scene::TextureIndex(0), TextureEncoding::linear, asked, found);
                for (std::size_t lane = 0; lane < expected.size(); ++lane) {
                    ASSERT_EQ(found.x[lane], expected[lane].r) << "lane " << lane;
                    ASSERT_EQ(found.y[lane], expected[lane].g) << "lane " << lane;
                    ASSERT_EQ(found.z[lane], expected[lane].b) << "lane " << lane;
                }
            }
        }
    }
}

}  // namespace
}  // namespace balcony::render::test::nearest_texture_test
