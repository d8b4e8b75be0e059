// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Texture look-ups by themselves: textures held in memory against the laws of filtering and against
// OpenImageIO's texture system, which serves those that do not fit.

#include "render/textures/texture_library.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::render::test::texture_library_test {
namespace {

using Imath::Color4f;
using Imath::V2f;
using scene::Wrap;

constexpr std::size_t plenty = default_texture_memory;
constexpr float half_code = 0.5F / 255.0F;

std::uint8_t code(double value) { return static_cast<std::uint8_t>(std::lround(255.0 * value)); }

scene::Scene textured(std::vector<std::uint8_t> png, Wrap wrap = Wrap::repeat) {
    scene::Scene scene;
    scene::Material material = white();
    material.roughness_texture.index = add_texture(scene, std::move(png));
    scene.textures[0].wrap_u = scene.textures[0].wrap_v = wrap;
    add(scene, wall(0.0F, 1.0F), material);
    return scene;
}

scene::Scene grey(int width, int height, const std::function<double(int x, int y)>& value,
                  Wrap wrap = Wrap::repeat) {
    return textured(
        encode_png(width, height, 3,
                   [&](int x, int y) { return std::vector<std::uint8_t>(3, code(value(x, y))); }),
        wrap);
}

// The linear texture of a scene, held in memory or served by the cache.
class Sampled {
public:
    Sampled(const scene::Scene& scene, std::size_t memory) : library_(scene, memory, warnings_) {
        EXPECT_TRUE(warnings_.empty()) << to_text(warnings_);
        EXPECT_EQ(library_.held_bytes() > 0, memory == plenty);
    }

    [[nodiscard]] Color4f operator()(const TextureFootprint& footprint) const {
        return library_.look_up(scene::TextureIndex(0), TextureEncoding::linear, footprint,
                                library_.thread_cache());
    }
    [[nodiscard]] float red(const TextureFootprint& footprint) const {
        return (*this)(footprint).r;
    }

private:
    Diagnostics warnings_;
    TextureLibrary library_;
};

// Ellipses with diameters up to `longest` at places of the unit square that are `margin` inside.
TextureFootprint random_footprint(std::mt19937& random, float longest, float margin) {
    std::uniform_real_distribution<float> place(margin, 1.0F - margin);
    std::uniform_real_distribution<float> part(-1.0F, 1.0F);
    const float length = longest * std::exp2(4.0F * (part(random) - 1.0F)) / std::sqrt(2.0F);
    return {{place(random), place(random)},
            {length * part(random), length * part(random)},
            {length * part(random), length * part(random)}};
}

// Every symmetric filter returns a linear function as it is. In each of the two, half a code is the
// rounding of the texels.
TEST(TextureLibrary, BothSamplersReturnALinearRamp) {
    const scene::Scene scene = grey(
        256, 256, [](int x, int y) { return (x + y + 1) / 512.0; }, Wrap::clamp);
    const Sampled held(scene, plenty);
    const Sampled cached(scene, 0);
    std::mt19937 random(3);
    for (int trial = 0; trial < 500; ++trial) {
        const TextureFootprint footprint = random_footprint(random, 0.1F, 0.25F);
        const float expected = 0.5F * (footprint.at.x + footprint.at.y);
        EXPECT_NEAR(held.red(footprint), expected, half_code + 1e-5F) << trial;
        // A half float rounds to 2^-12.
        EXPECT_NEAR(cached.red(footprint), expected, half_code + 0x1p-12F) << trial;
    }
}

// A filter of radius r differs from the function at its centre by at most r² / 2 times the second
// derivative. The samplers' radii are at most the longer diameter and two texels of the level in
// use, which are no wider than the diameter or the image's texel.
TEST(TextureLibrary, BothSamplersAgreeOnASmoothImage) {
    constexpr double frequency = 2.0 * std::numbers::pi;
    constexpr int side = 300;
    const scene::Scene scene = grey(side, side, [](int x, int y) {
        return 0.5 + 0.25 * std::cos(frequency * (x + 0.5) / side) +
               0.25 * std::sin(frequency * (y + 0.5) / side);
    });
    const Sampled held(scene, plenty);
    const Sampled cached(scene, 0);
    std::mt19937 random(4);
    for (int trial = 0; trial < 500; ++trial) {
        TextureFootprint footprint = random_footprint(random, 0.05F, -1.0F);
        const float diameter = std::sqrt(footprint.along_x.length2() + footprint.along_y.length2());
        const float radius = diameter + 2.0F * std::max(diameter, 1.0F / side);
        const auto bend = static_cast<float>(0.25 * frequency * frequency);
        EXPECT_NEAR(held.red(footprint), cached.red(footprint),
                    bend * radius * radius + 2.0F * half_code)
            << trial;
    }
}

TEST(TextureLibrary, BothSamplersWrapAlike) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
        const scene::Scene scene = grey(
            5, 3, [](int x, int y) { return (x + 5 * y) / 14.0; }, wrap);
        const Sampled held(scene, plenty);
        const Sampled cached(scene, 0);
        std::mt19937 random(5);
        std::uniform_real_distribution<float> place(-3.0F, 3.0F);
        for (int trial = 0; trial < 500; ++trial) {
            const TextureFootprint point{{place(random), place(random)}, V2f(0.0F), V2f(0.0F)};
            // A half float rounds to 2^-12; positions near 3 to 2^-23, times 5 texels.
            EXPECT_NEAR(held.red(point), cached.red(point), 0x1p-11F)
                << static_cast<int>(wrap) << ' ' << point.at;
        }
        EXPECT_NEAR(held.red({{0.1F, 0.5F}, V2f(0.0F), V2f(0.0F)}), 5.0F / 14.0F, half_code);
    }
}

TEST(TextureLibrary, AWideFootprintIsTheMeanOfTheImage) {
    for (const auto& [width, height] : {std::pair(7, 5), std::pair(1, 9), std::pair(2, 2),
                                        std::pair(64, 3), std::pair(301, 200)}) {
        std::mt19937 random(6);
        std::uniform_real_distribution<double> value(0.0, 1.0);
        double sum = 0.0;
        const scene::Scene scene = grey(width, height, [&](int, int) {
            const double drawn = value(random);
            sum += code(drawn) / 255.0;
            return drawn;
        });
        const Sampled held(scene, plenty);
        const float expected = static_cast<float>(sum / (width * height));
        for (const float diameter : {16.0F, 60.0F}) {
            EXPECT_NEAR(held.red({{0.3F, 0.8F}, {diameter, 0.0F}, {0.0F, diameter}}), expected,
                        half_code + 1e-5F)
                << width << ' ' << height << ' ' << diameter;
        }
    }
}

// Whatever the footprint, the look-ups at all texels weigh all texels alike.
TEST(TextureLibrary, LookUpsAtAllTexelsHaveTheMeanOfTheImage) {
    constexpr int side = 16;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> value(0.0, 1.0);
    double expected = 0.0;
    const scene::Scene scene = grey(side, side, [&](int, int) {
        const double drawn = value(random);
        expected += code(drawn) / (255.0 * side * side);
        return drawn;
    });
    const Sampled held(scene, plenty);
    for (int trial = 0; trial < 50; ++trial) {
        TextureFootprint footprint = random_footprint(random, 1.0F, 0.0F);
        const V2f first = footprint.at;
        double sum = 0.0;
        for (int i = 0; i < side * side; ++i) {
            footprint.at = first + V2f(static_cast<float>(i % side) / side,
                                       static_cast<float>(i / side) / side);
            sum += static_cast<double>(held.red(footprint));
        }
        EXPECT_NEAR(sum / (side * side), expected, static_cast<double>(half_code)) << trial;
    }
}

// A footprint across stripes sees both colours, one along them only its own.
TEST(TextureLibrary, AnElongatedFootprintKeepsWhatIsBesideIt) {
    constexpr int side = 256;
    const scene::Scene scene = grey(side, side, [](int x, int) { return x / 16 % 2; });
    const Sampled held(scene, plenty);
    const float texel = 1.0F / side;
    const V2f middle_of_a_stripe(24.0F * texel, 0.4F);
    EXPECT_EQ(held.red({middle_of_a_stripe, {texel, 0.0F}, {0.0F, 16.0F * texel}}), 1.0F);
    // A period, by 16 probes of two texels' width.
    EXPECT_NEAR(held.red({middle_of_a_stripe, {32.0F * texel, 0.0F}, {0.0F, texel}}), 0.5F,
                half_code);
}

TEST(TextureLibrary, AFootprintThatIsNotFiniteIsAPoint) {
    const scene::Scene scene = grey(64, 64, [](int x, int y) { return (x + y) / 126.0; });
    const V2f place(0.3F, 0.7F);
    for (const std::size_t memory : {plenty, std::size_t{0}}) {
        const Sampled sampled(scene, memory);
        const float expected = sampled.red({place, V2f(0.0F), V2f(0.0F)});
        for (const float bad : {std::nanf(""), HUGE_VALF, -HUGE_VALF, 3e38F, 1e6F}) {
            EXPECT_EQ(sampled.red({place, {bad, 0.0F}, {0.0F, 0.01F}}), expected) << bad;
            EXPECT_EQ(sampled.red({place, {0.01F, 0.0F}, {bad, bad}}), expected) << bad;
            EXPECT_EQ(sampled({{bad, 0.5F}, V2f(0.0F), V2f(0.0F)}),
                      Color4f(1.0F, 1.0F, 1.0F, 1.0F));
        }
    }
}

TEST(TextureLibrary, AnImageOfOneTexelIsOneColor) {
    const scene::Scene scene = textured(encode_png(1, 1, 4, [](int, int) {
        return std::vector<std::uint8_t>{51, 102, 153, 204};
    }));
    const Sampled held(scene, plenty);
    std::mt19937 random(8);
    for (int trial = 0; trial < 100; ++trial) {
        const Color4f color = held(random_footprint(random, 20.0F, -10.0F));
        EXPECT_NEAR(color.r, 0.2F, 1e-6F);
        EXPECT_NEAR(color.g, 0.4F, 1e-6F);
        EXPECT_NEAR(color.b, 0.6F, 1e-6F);
        EXPECT_NEAR(color.a, 0.8F, 1e-6F);
    }
}

TEST(TextureLibrary, ACodeIsTheNearestOfAValue) {
    for (const TextureEncoding encoding : {TextureEncoding::linear, TextureEncoding::srgb}) {
        const ByteScale& scale = ByteScale::of(encoding);
        const auto encoded = [&](double value) {
            return encoding == TextureEncoding::linear ? value
                   : value <= 0.0031308                ? 12.92 * value
                                                       : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
        };
        for (int i = 0; i <= 100'000; ++i) {
            const double value = i / 100'000.0;
            // Half a code, and the rounding of floats in the limits.
            EXPECT_NEAR(scale.encode(static_cast<float>(value)), 255.0 * encoded(value), 0.5001)
                << value;
        }
        for (int i = 0; i < 256; ++i) {
            const auto byte = static_cast<std::uint8_t>(i);
            EXPECT_EQ(scale.encode(scale.decode(byte)), byte);
        }
    }
}

TEST(TextureLibrary, HoldsTheSmallTexturesWithinItsMemory) {
    scene::Scene scene;
    constexpr int count = 12;
    for (int i = 0; i < count; ++i) {
        // Two large ones among small ones, each with its own grey.
        const int side = i % 6 == 0 ? 128 : 32;
        scene::Material material = white();
        material.roughness_texture.index =
            add_texture(scene, encode_png(side, side, 3, [&](int, int) {
                            return std::vector<std::uint8_t>(3, static_cast<std::uint8_t>(20 * i));
                        }));
        add(scene, wall(0.0F, 1.0F), material);
    }
    // All take 10 * 5,460 + 2 * 87,380 bytes.
    for (const std::size_t memory : {300'000U, 150'000U, 60'000U, 0U}) {
        Diagnostics warnings;
        const TextureLibrary library(scene, memory, warnings);
        EXPECT_TRUE(warnings.empty());
        EXPECT_LE(library.held_bytes(), memory);
        EXPECT_GE(library.held_bytes(), memory < 87'380 ? memory / 2 : memory / 3);
        library.read_all();
        for (int i = 0; i < count; ++i) {
            const Color4f found = library.look_up(
                scene::TextureIndex(static_cast<std::uint32_t>(i)), TextureEncoding::linear,
                {V2f(0.5F), V2f(0.0F), V2f(0.0F)}, library.thread_cache());
            EXPECT_NEAR(found.r, static_cast<float>(20 * i) / 255.0F, 0x1p-12F) << memory;
        }
        EXPECT_TRUE(library.warnings().empty());
    }
}

TEST(TextureLibrary, ValuesThatAreNotFiniteAreZeroWithAWarning) {
    constexpr int side = 8;
    const std::string file = ::testing::TempDir() + "balcony_nan_texture.exr";
    const auto output = OIIO::ImageOutput::create(file);
    ASSERT_TRUE(output->open(file, OIIO::ImageSpec(side, side, 3, OIIO::TypeDesc::FLOAT)));
    std::vector<float> values(std::size_t{3} * side * side, 0.25F);
    values[0] = std::nanf("");
    values[3] = HUGE_VALF;
    values[6] = 1e30F;
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close());
    scene::Scene scene = textured({});
    scene.textures[0].file = file;
    for (const std::size_t memory : {plenty, std::size_t{0}}) {
        Diagnostics warnings;
        const TextureLibrary library(scene, memory, warnings);
        const auto texel = [&](float x) {
            return library.look_up(scene::TextureIndex(0), TextureEncoding::linear,
                                   {{(x + 0.5F) / side, 0.5F / side}, V2f(0.0F), V2f(0.0F)},
                                   library.thread_cache());
        };
        EXPECT_EQ(texel(0).r, 0.0F);
        EXPECT_EQ(texel(1).r, 0.0F);
        EXPECT_EQ(texel(2).r, 65504.0F);
        EXPECT_EQ(texel(3).r, 0.25F);
        warnings = library.warnings();
        ASSERT_EQ(warnings.size(), 1U);
        EXPECT_NE(warnings[0].message.find("not finite"), std::string::npos);
        EXPECT_TRUE(library.warnings().empty());
    }
}

}  // namespace
}  // namespace balcony::render::test::texture_library_test
