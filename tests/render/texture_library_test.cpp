// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Texture look-ups by themselves: the laws of filtering, and textures that do not fit into memory.

#include "shading/textures/texture_library.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <set>
#include <thread>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "../files/temporary_folder.hpp"
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

// With this image file of a format; the values are those of the pixels, row by row.
scene::Scene textured_by(const std::filesystem::path& file, int side, OIIO::TypeDesc format,
                         const std::vector<float>& values) {
    const auto output = OIIO::ImageOutput::create(file.string());
    const int channels = static_cast<int>(values.size()) / (side * side);
    EXPECT_TRUE(output->open(file.string(), OIIO::ImageSpec(side, side, channels, format)) &&
                output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close());
    scene::Scene scene = textured({});
    scene.textures[0].file = file;
    return scene;
}

scene::Scene grey(int width, int height, const std::function<double(int x, int y)>& value,
                  Wrap wrap = Wrap::repeat) {
    return textured(
        encode_png(width, height, 3,
                   [&](int x, int y) { return std::vector<std::uint8_t>(3, code(value(x, y))); }),
        wrap);
}

// The linear texture of a scene, held in memory or in a file.
class Sampled {
public:
    Sampled(const scene::Scene& scene, std::size_t memory) : library_(scene, memory, warnings_) {
        EXPECT_TRUE(warnings_.empty()) << to_text(warnings_);
        EXPECT_EQ(library_.held_bytes() > 0, memory == plenty);
    }

    [[nodiscard]] Color4f operator()(const TextureFootprint& footprint) const {
        return library_.look_up(scene::TextureIndex(0), TextureEncoding::linear, footprint);
    }
    [[nodiscard]] float red(const TextureFootprint& at) const { return (*this)(at).r; }
    [[nodiscard]] const TextureLibrary& library() const { return library_; }

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

// Every symmetric filter returns a linear function as it is; half a code is the rounding of the
// texels.
TEST(TextureLibrary, ALinearRampStaysAsItIs) {
    const scene::Scene scene = grey(
        256, 256, [](int x, int y) { return (x + y + 1) / 512.0; }, Wrap::clamp);
    const Sampled held(scene, plenty);
    std::mt19937 random(3);
    for (int trial = 0; trial < 500; ++trial) {
        const TextureFootprint footprint = random_footprint(random, 0.1F, 0.25F);
        const float expected = 0.5F * (footprint.at.x + footprint.at.y);
        EXPECT_NEAR(held.red(footprint), expected, half_code + 1e-5F) << trial;
    }
}

TEST(TextureLibrary, TheWrapModesContinueTheImage) {
    const auto value = [](int x, int y) { return static_cast<float>(x + 5 * y) / 14.0F; };
    const auto index = [](Wrap wrap, int i, int count) {
        const int repeated = (i % count + count) % count;
        return wrap == Wrap::clamp ? std::clamp(i, 0, count - 1)
               : wrap == Wrap::repeat || repeated == i % (2 * count) ||
                       repeated == i % (2 * count) + 2 * count
                   ? repeated
                   : count - 1 - repeated;
    };
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
        const scene::Scene scene = grey(5, 3, value, wrap);
        const Sampled held(scene, plenty);
        for (int y = -7; y < 9; ++y) {
            for (int x = -12; x < 15; ++x) {
                const V2f center((static_cast<float>(x) + 0.5F) / 5.0F,
                                 (static_cast<float>(y) + 0.5F) / 3.0F);
                // The rounding of a place near 3, times 5 texels, moves by at most 2e-6 texels.
                EXPECT_NEAR(held.red({center, V2f(0.0F), V2f(0.0F)}),
                            value(index(wrap, x, 5), index(wrap, y, 3)), half_code + 1e-5F)
                    << static_cast<int>(wrap) << ' ' << x << ' ' << y;
            }
        }
    }
}

// Expects that the rays of a packet together find what each finds by itself.
void expect_same_in_lanes(const TextureLibrary& library,
                          const std::array<TextureFootprint, lane_count>& asked) {
    const scene::TextureIndex texture(0);
    texture_lanes::Footprints footprints;
    for (std::size_t lane = 0; lane < asked.size(); ++lane) {
        const TextureFootprint& one = asked[lane];
        footprints.at.set(lane, one.at);
        footprints.along_x.set(lane, one.along_x);
        footprints.along_y.set(lane, one.along_y);
    }
    LaneVectors found;
    library.look_up(texture, TextureEncoding::linear, footprints, found);
    for (std::size_t lane = 0; lane < asked.size(); ++lane) {
        const Color4f expected = library.look_up(texture, TextureEncoding::linear, asked[lane]);
        ASSERT_EQ(found.x[lane], expected.r) << "lane " << lane;
        ASSERT_EQ(found.y[lane], expected.g) << "lane " << lane;
        ASSERT_EQ(found.z[lane], expected.b) << "lane " << lane;
    }
}

TEST(TextureLibrary, TheRaysOfAPacketFindTheSameBits) {
    std::mt19937 random(6);
    const auto noise = [&](int, int) {
        const auto channel = [&] { return static_cast<std::uint8_t>(random() % 256); };
        return std::vector<std::uint8_t>{channel(), channel(), channel()};
    };
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
        for (const auto& [width, height] : {std::pair(37, 21), {64, 256}, {1, 1}, {1, 9}}) {
            const scene::Scene scene = textured(encode_png(width, height, 3, noise), wrap);
            for (const std::size_t memory : {plenty, std::size_t{0}}) {
                const Sampled sampled(scene, memory);
                for (int trial = 0; trial < 200; ++trial) {
                    std::array<TextureFootprint, lane_count> asked;
                    for (TextureFootprint& one : asked) {
                        one = random_footprint(random, trial % 4 == 0 ? 20.0F : 0.1F, -2.0F);
                    }
                    expect_same_in_lanes(sampled.library(), asked);
                    // A point, points on borders, and what is out of range.
                    asked[1] = {asked[1].at, V2f(0.0F), V2f(0.0F)};
                    asked[2].at = {-1.0F, 1.0F};
                    asked[3].at.x = 2.0F * ImageLevels::max_coordinate;
                    asked[4].along_y.y = std::nanf("");
                    expect_same_in_lanes(sampled.library(), asked);
                }
            }
        }
    }
}

// Whether a texture is in memory or in a file changes no bit, though the file's chunks come and go.
TEST(TextureLibrary, AFileGivesTheSameBitsInLittleMemory) {
    constexpr int side = 1500;
    std::mt19937 random(4);
    const scene::Scene scene =
        grey(side, side, [&](int, int) { return static_cast<double>(random() % 256) / 255.0; });
    const Sampled held(scene, plenty);
    const Sampled filed(scene, 0);
    constexpr std::size_t limit = 16 * TexelBlock::chunk_bytes;
    std::size_t most = 0;
    for (int trial = 0; trial < 20'000; ++trial) {
        const TextureFootprint footprint = random_footprint(random, 0.02F, -1.0F);
        ASSERT_EQ(filed(footprint), held(footprint)) << trial;
        most = std::max(most, filed.library().file_bytes_in_memory());
    }
    EXPECT_EQ(most, limit);  // The whole takes eight times as much.
    EXPECT_EQ(held.library().file_bytes_in_memory(), 0U);
}

TEST(TextureLibrary, ThreadsMayShareAFile) {
    const scene::Scene scene = grey(700, 700, [](int x, int y) { return x * y % 256 / 255.0; });
    const Sampled held(scene, plenty);
    const Sampled filed(scene, 0);
    std::vector<std::thread> threads;
    std::atomic<int> different = 0;
    for (unsigned seed = 0; seed < 4; ++seed) {
        threads.emplace_back([&, seed] {
            std::mt19937 random(seed);
            for (int trial = 0; trial < 5'000; ++trial) {
                const TextureFootprint footprint = random_footprint(random, 0.02F, -1.0F);
                different += filed(footprint) == held(footprint) ? 0 : 1;
            }
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    EXPECT_EQ(different, 0);
}

// The open files without a name: that of texels, and what this process has inherited.
std::set<int> files_without_a_name() {
    std::set<int> found;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
        std::error_code ignored;
        if (read_symlink(entry.path(), ignored).string().ends_with("(deleted)")) {
            found.insert(std::stoi(entry.path().filename().string()));
        }
    }
    return found;
}

// As on a disk that fails; a map of the file into memory would end the process by SIGBUS.
TEST(TextureLibrary, AFileThatCannotBeReadAnyMoreIsAWarning) {
    constexpr int side = 1500;
    const scene::Scene scene = grey(side, side, [](int, int) { return 0.2; });
    const std::set<int> others = files_without_a_name();
    const Sampled filed(scene, 0);
    const auto at = [&](float v) { return filed({{0.5F, v}, V2f(0.0F), V2f(0.0F)}); };
    EXPECT_NEAR(at(0.1F).r, 0.2F, half_code);
    std::set<int> files = files_without_a_name();
    std::erase_if(files, [&](int file) { return others.contains(file); });
    ASSERT_EQ(files.size(), 1U);
    ASSERT_EQ(ftruncate(*files.begin(), 0), 0);
    (void)at(0.9F);  // The first look-up that notices.
    EXPECT_EQ(at(0.1F), Color4f(1.0F, 1.0F, 1.0F, 1.0F));
    EXPECT_EQ(at(0.5F), Color4f(1.0F, 1.0F, 1.0F, 1.0F));
    const Diagnostics warnings = filed.library().warnings();
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].message.find("cannot be read any more"), std::string::npos);
    EXPECT_NE(warnings[0].remedy.find("TMPDIR"), std::string::npos);
    EXPECT_TRUE(filed.library().warnings().empty());
}

TEST(TextureLibrary, AFolderThatCannotHoldTheFileIsAWarning) {
    const char* const before = std::getenv("TMPDIR");
    const std::string restored = before != nullptr ? before : "";
    setenv("TMPDIR", "/nowhere/at/all", 1);
    const scene::Scene scene = grey(8, 8, [](int, int) { return 0.5; });
    Diagnostics warnings;
    const TextureLibrary library(scene, 0, warnings);
    const TextureFootprint middle{V2f(0.5F), V2f(0.0F), V2f(0.0F)};
    const Color4f found = library.look_up(scene::TextureIndex(0), TextureEncoding::linear, middle);
    before != nullptr ? setenv("TMPDIR", restored.c_str(), 1) : unsetenv("TMPDIR");
    EXPECT_EQ(found, Color4f(1.0F, 1.0F, 1.0F, 1.0F));
    warnings = library.warnings();
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].message.find("/nowhere/at/all"), std::string::npos);
    EXPECT_NE(warnings[0].remedy.find("TMPDIR"), std::string::npos);
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
            const Color4f found =
                library.look_up(scene::TextureIndex(static_cast<std::uint32_t>(i)),
                                TextureEncoding::linear, {V2f(0.5F), V2f(0.0F), V2f(0.0F)});
            EXPECT_NEAR(found.r, static_cast<float>(20 * i) / 255.0F, 0x1p-12F) << memory;
        }
        EXPECT_TRUE(library.warnings().empty());
    }
}

// The middle of a texel of a square image, counted row by row.
TextureFootprint texel_of(std::size_t i, std::size_t side) {
    const auto middle = [&](std::size_t n) {
        return (static_cast<float>(n) + 0.5F) / static_cast<float>(side);
    };
    return {{middle(i % side), middle(i / side)}, V2f(0.0F), V2f(0.0F)};
}

// Images of more than 8 bits: each channel is a half float, by itself and for packets.
TEST(TextureLibrary, AnImageOfFloatsHasHalfFloats) {
    std::mt19937 random(9);
    std::uniform_real_distribution<float> value(0.0F, 40.0F);
    std::vector<float> values(std::size_t{4} * 16 * 16);
    std::generate(values.begin(), values.end(), [&] { return value(random); });
    const files::TemporaryFolder folder;
    const scene::Scene scene = textured_by(folder / "float.exr", 16, OIIO::TypeDesc::FLOAT, values);
    const Sampled held(scene, plenty);
    for (std::size_t i = 0; i < values.size(); i += 4) {
        const auto half = [&](std::size_t k) { return float{Imath::half(values[i + k])}; };
        EXPECT_EQ(held(texel_of(i / 4, 16)), Color4f(half(0), half(1), half(2), half(3)));
    }
    for (int trial = 0; trial < 100; ++trial) {
        std::array<TextureFootprint, lane_count> asked;
        for (TextureFootprint& one : asked) {
            one = random_footprint(random, 1.0F, -1.0F);
        }
        expect_same_in_lanes(held.library(), asked);
    }
}

TEST(TextureLibrary, AnImageOf16BitsIsDecodedFromSrgb) {
    std::vector<float> values(std::size_t{3} * 16 * 16);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = static_cast<float>(i) / static_cast<float>(values.size() - 1);
    }
    const files::TemporaryFolder folder;
    scene::Scene scene = textured_by(folder / "deep.png", 16, OIIO::TypeDesc::UINT16, values);
    std::swap(scene.materials[0].roughness_texture, scene.materials[0].base_color_texture);
    scene.materials[0].base_color_texture.encoding = TextureEncoding::srgb;
    Diagnostics warnings;
    const TextureLibrary library(scene, plenty, warnings);
    for (std::size_t i = 0; i < values.size(); i += 3) {
        const Color4f found =
            library.look_up(scene::TextureIndex(0), TextureEncoding::srgb, texel_of(i / 3, 16));
        for (const auto& [linear, stored] :
             {std::pair(found.r, values[i]), {found.g, values[i + 1]}, {found.b, values[i + 2]}}) {
            const float expected = linear_from_srgb(stored);
            // A half float has 11 bits; a step of 16 bits is 1/65535, with a slope of at most 2.4.
            EXPECT_NEAR(linear, expected, 0x1p-11F * expected + 2.4F / 65535.0F) << i;
        }
    }
}

TEST(TextureLibrary, ValuesThatAreNotFiniteAreZeroWithAWarning) {
    constexpr int side = 8;
    std::vector<float> values(std::size_t{3} * side * side, 0.25F);
    values[0] = std::nanf("");
    values[3] = HUGE_VALF;
    values[6] = 1e30F;
    const files::TemporaryFolder folder;
    const scene::Scene scene = textured_by(folder / "nan.exr", side, OIIO::TypeDesc::FLOAT, values);
    for (const std::size_t memory : {plenty, std::size_t{0}}) {
        Diagnostics warnings;
        const TextureLibrary library(scene, memory, warnings);
        const auto texel = [&](std::size_t x) {
            return library.look_up(scene::TextureIndex(0), TextureEncoding::linear,
                                   texel_of(x, side));
        };
        EXPECT_EQ(texel(0).r, 0.0F);
        EXPECT_EQ(texel(1).r, 0.0F);
        EXPECT_EQ(texel(2).r, 65504.0F);
        EXPECT_EQ(texel(3).r, 0.25F);
        expect_same_in_lanes(library, {TextureFootprint{V2f(0.2F, 0.1F), V2f(0.1F), V2f(0.2F)}});
        warnings = library.warnings();
        ASSERT_EQ(warnings.size(), 1U);
        EXPECT_NE(warnings[0].message.find("not finite"), std::string::npos);
        EXPECT_TRUE(library.warnings().empty());
    }
}

}  // namespace
}  // namespace balcony::render::test::texture_library_test
