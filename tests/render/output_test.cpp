// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Films in files, read back.

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "../files/temporary_folder.hpp"
#include "film/files/exr_channels.hpp"
#include "film/sums/film_arrays.hpp"
#include "support.hpp"

namespace balcony::render::test::output_test {
namespace {

namespace fs = std::filesystem;

class Output : public testing::Test {
protected:
    [[nodiscard]] std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
    }

    const files::TemporaryFolder folder_;
};

// Two objects, one hidden from half of the picture, rays in the upper part only.
Rendered two_objects() {
    scene::Scene scene;
    scene::Material red = white();
    red.base_color = Color3f(0.8F, 0.1F, 0.05F);
    add(scene, wall(-2.0F, 0.7F), red);
    add(scene, parallelogram({0.0F, -0.5F, -1.0F}, {3.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}),
        white());
    return render(scene, orthographic(view_down_z(0.0, 0.0, 0.0)), request(37, 83, "preview", 3));
}

std::vector<float> read(const fs::path& file, std::vector<std::string>* channels = nullptr,
                        OIIO::ImageSpec* spec = nullptr) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(file.string(), &config);
    EXPECT_TRUE(input) << OIIO::geterror();
    std::vector<float> values(static_cast<std::size_t>(input->spec().image_pixels()) *
                              static_cast<std::size_t>(input->spec().nchannels));
    EXPECT_TRUE(
        input->read_image(0, 0, 0, input->spec().nchannels, OIIO::TypeDesc::FLOAT, values.data()));
    if (channels != nullptr) {
        *channels = input->spec().channelnames;
    }
    if (spec != nullptr) {
        *spec = input->spec();
    }
    return values;
}

float srgb(float linear) {
    return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

TEST_F(Output, PngHoldsSrgbAndStraightAlpha) {
    const Film film = two_objects().film;
    for (const int bits : {8, 16}) {
        const fs::path file = folder_ / "picture.png";
        ASSERT_TRUE(write(film, file, {.exposure = -1.0, .bits = bits, .dither = false}).empty());
        const std::vector<float> values = read(file);
        ASSERT_EQ(values.size(), 37U * 83U * 4U);
        const float half_step = 0.5F / static_cast<float>((1 << bits) - 1) + 1e-6F;
        bool partial = false;
        for (std::size_t i = 0; i < 37 * 83; ++i) {
            const Color4f mean = film.pixel(i % 37, i / 37);
            partial = partial || (mean.a > 0.0F && mean.a < 1.0F);
            ASSERT_NEAR(values[4 * i + 3], mean.a, half_step);
            // Below the highlights that are compressed.
            ASSERT_NEAR(values[4 * i], mean.a > 0.0F ? srgb(0.5F * mean.r / mean.a) : 0.0F,
                        half_step);
        }
        EXPECT_TRUE(partial);
    }
    EXPECT_EQ(files(), 1U);
}

// One row of pixels: bright light, a frame, half of each, half light over nothing, nothing, and a
// mirror that reflects what is behind the scene.
Film light_and_display() {
    Film film = *make_film({.width = 6, .height = 1, .data_layers = false});
    film.passes = {1};
    film.sum = {Color4d(300.0, 300.0, 300.0, 1.0), Color4d(0.0), Color4d(150.0, 150.0, 150.0, 0.5),
                Color4d(150.0, 150.0, 150.0, 0.5), Color4d(0.0), Color4d(0.0, 0.0, 0.0, 1.0)};
    film.display.assign(6, Color4d(0.0));
    film.display[1] = Color4d(0.7, 0.2, 0.1, 1.0);
    film.display[2] = 0.5 * film.display[1];
    film.mirrored.assign(6, Color4d(0.0));
    film.mirrored[5] = Color4d(0.9, 0.5, 0.25, 0.0);
    film.ambient = Color3f(80.0F);
    return film;
}

TEST_F(Output, ExposureIsForLightNotForDisplayColours) {
    const Film film = light_and_display();
    const fs::path file = folder_ / "a.png";
    ASSERT_TRUE(write(film, file, {.exposure = -9.0, .dither = false}).empty());
    const std::vector<float> shown = read(file);
    const float light = 300.0F / 512.0F;
    constexpr float half_step = 0.5F / 255.0F + 1e-6F;
    const auto expect = [&](std::size_t pixel, float red, float alpha) {
        EXPECT_NEAR(shown[4 * pixel], srgb(red), half_step) << pixel;
        EXPECT_NEAR(shown[4 * pixel + 3], alpha, half_step) << pixel;
    };
    expect(0, light, 1.0F);
    expect(1, 0.7F, 1.0F);
    expect(2, 0.5F * light + 0.5F * 0.7F, 1.0F);
    expect(3, light, 0.5F);
    expect(4, 0.0F, 0.0F);
    expect(5, 0.9F * 80.0F / 512.0F, 1.0F);
}

TEST_F(Output, TheBackgroundFillsWhatIsLeft) {
    Film film = light_and_display();
    film.background = Color3f(0.4F);
    const fs::path file = folder_ / "a.png";
    ASSERT_TRUE(write(film, file, {.exposure = -9.0, .dither = false}).empty());
    const std::vector<float> shown = read(file);
    const float light = 300.0F / 512.0F;
    constexpr float half_step = 0.5F / 255.0F + 1e-6F;
    const float reds[] = {light, 0.7F,       0.5F * light + 0.5F * 0.7F, 0.5F * light + 0.5F * 0.4F,
                          0.4F,  0.9F * 0.4F};
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_NEAR(shown[4 * i], srgb(reds[i]), half_step) << i;
        EXPECT_EQ(shown[4 * i + 3], 1.0F) << i;
    }
}

// An opaque film of 96 x 64 pixels whose light has a given sRGB level, from 0 to 255.
Film film_of_levels(const std::function<double(std::size_t x)>& level) {
    Film film = *make_film({.width = 96, .height = 64, .data_layers = false});
    film.passes.assign(film.tile_count(), 1);
    for (std::size_t i = 0; i < film.sum.size(); ++i) {
        const double value = level(i % 96) / 255.0;
        const double linear =
            value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
        film.sum[i] = Color4d(linear, linear, linear, 1.0);
    }
    return film;
}

constexpr DisplayOptions as_light{.view = ViewTransform::standard};

// 96 columns between two levels: rounding would show a step in the middle.
TEST_F(Output, DitheringKeepsTheMeanOfAnArea) {
    const auto level = [](std::size_t x) { return 100.0 + static_cast<double>(x) / 96.0; };
    const Film film = film_of_levels(level);
    ASSERT_TRUE(write(film, folder_ / "a.png", as_light).empty());
    const std::vector<float> shown = read(folder_ / "a.png");
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t left = 0; left < 96; left += 16) {
            double error = 0.0;
            for (std::size_t i = 0; i < 16 * 64; ++i) {
                const std::size_t x = left + i % 16;
                const double value = 255.0 * double{shown[4 * (i / 16 * 96 + x) + c]};
                ASSERT_LT(std::abs(value - level(x)), 1.0);
                error += (value - level(x)) / (16.0 * 64.0);
            }
            // The discrepancy of the pattern over 1024 points is below 10 of them.
            EXPECT_LT(std::abs(error), 0.01) << left;
        }
    }
    DisplayOptions rounded = as_light;
    rounded.dither = false;
    ASSERT_TRUE(write(film, folder_ / "a.png", rounded).empty());
    EXPECT_NEAR(read(folder_ / "a.png")[4 * 10], 100.0F / 255.0F, 1e-6F);
}

TEST_F(Output, DitheringLeavesExactLevels) {
    const Film film = film_of_levels([](std::size_t x) { return 2.0 * static_cast<double>(x); });
    ASSERT_TRUE(write(film, folder_ / "a.png", as_light).empty());
    const std::vector<float> shown = read(folder_ / "a.png");
    for (std::size_t i = 0; i < 96 * 64; ++i) {
        ASSERT_NEAR(shown[4 * i], static_cast<float>(2 * (i % 96)) / 255.0F, 1e-6F) << i;
    }
}

// Frames and backgrounds of any colour have the nearest level.
TEST_F(Output, PixelsWithoutLightAreNotDithered) {
    Film film = film_of_levels([](std::size_t) { return 0.0; });
    film.sum.assign(film.sum.size(), Color4d(0.0));
    film.display.assign(film.sum.size(), Color4d(0.3, 0.3, 0.3, 1.0));
    for (std::size_t i = 0; i < 96; ++i) {
        film.display[i] = Color4d(0.0);
    }
    film.background = Color3f(0.2F);
    ASSERT_TRUE(write(film, folder_ / "a.png").empty());
    const std::vector<float> shown = read(folder_ / "a.png");
    constexpr float half_step = 0.5F / 255.0F + 1e-6F;
    for (std::size_t i = 0; i < 96 * 64; ++i) {
        ASSERT_EQ(shown[4 * i], shown[i < 96 ? 0 : 4 * 96]) << i;
    }
    EXPECT_NEAR(shown[0], srgb(0.2F), half_step);
    EXPECT_NEAR(shown[4 * 96], srgb(0.3F), half_step);
}

// A program that exposes an EXR file takes the light, and adds the display colours afterwards.
TEST_F(Output, ExrKeepsDisplayColoursApart) {
    Film film = light_and_display();
    for (const bool filled : {false, true}) {
        film.background = filled ? std::optional(Color3f(0.4F)) : std::nullopt;
        ASSERT_TRUE(write_exr(film, folder_ / "a.exr").empty());
        std::vector<std::string> channels;
        const std::vector<float> values = read(folder_ / "a.exr", &channels);
        ASSERT_EQ(channels.size(), 8U);
        const auto at = [&](std::size_t pixel, const char* name) {
            const auto found = std::find(channels.begin(), channels.end(), name);
            return values[8 * pixel + static_cast<std::size_t>(found - channels.begin())];
        };
        for (std::size_t i = 0; i < 6; ++i) {
            const Color4f light = film.light(i, 0);
            const float rest = filled ? 1.0F - film.pixel(i, 0).a : 0.0F;
            EXPECT_NEAR(at(i, "display.R"), film.display_color(i, 0).r + 0.4F * rest, 1e-5F);
            EXPECT_NEAR(at(i, "display.A"), film.display_color(i, 0).a + rest, 1e-5F);
            EXPECT_NEAR(at(i, "R"), light.r + at(i, "display.R"), 1e-4F) << i;
            EXPECT_NEAR(at(i, "A"), light.a + at(i, "display.A"), 1e-6F) << i;
        }
    }
}

TEST_F(Output, ExrHoldsEveryLayerUnderItsName) {
    const Film film = two_objects().film;
    const fs::path file = folder_ / "picture.exr";
    ASSERT_TRUE(write_exr(film, file).empty());
    std::vector<std::string> channels;
    OIIO::ImageSpec spec;
    const std::vector<float> values = read(file, &channels, &spec);
    const DataLayers& layers = *film.layers;
    using Value = std::function<float(std::size_t)>;
    const std::vector<std::pair<std::string, Value>> expected = {
        {"R", [&](std::size_t i) { return film.pixel(i % 37, i / 37).r; }},
        {"A", [&](std::size_t i) { return film.pixel(i % 37, i / 37).a; }},
        {"ray_length.Z", [&](std::size_t i) { return layers.ray_length[i]; }},
        {"position.Z", [&](std::size_t i) { return layers.position[i].z; }},
        {"normal.Y", [&](std::size_t i) { return layers.normal[i].y; }},
        {"albedo.G", [&](std::size_t i) { return layers.albedo[i].y; }},
        {"object.X", [&](std::size_t i) { return static_cast<float>(layers.object[i]); }},
        {"origin.X", [&](std::size_t i) { return layers.origin[i].x; }},
        {"direction.Z", [&](std::size_t i) { return layers.direction[i].z; }},
        {"parameters.U", [&](std::size_t i) { return layers.parameters[i].x; }},
        {"parameters.A", [&](std::size_t i) { return static_cast<float>(layers.valid[i]); }},
        {"samples.X", [](std::size_t) { return 3.0F; }},
        {"valid.A", [&](std::size_t i) { return static_cast<float>(layers.valid[i]); }},
        {"layer.X", [&](std::size_t i) { return static_cast<float>(layers.layer[i]); }},
    };
    EXPECT_EQ(channels.size(), 27U);
    for (const auto& [name, value] : expected) {
        const auto found = std::find(channels.begin(), channels.end(), name);
        ASSERT_NE(found, channels.end()) << name;
        const auto c = static_cast<std::size_t>(found - channels.begin());
        for (std::size_t i = 0; i < 37 * 83; ++i) {
            ASSERT_EQ(values[i * channels.size() + c], value(i)) << name << ' ' << i;
        }
    }
    const OIIO::ParamValue* names = spec.find_attribute("objects");
    ASSERT_NE(names, nullptr);
    EXPECT_EQ(names->get_string_indexed(0), "object 0");
    EXPECT_EQ(names->get_string_indexed(1), "object 1");
}

TEST_F(Output, ExrWithoutLayersHasOnlyThePicture) {
    Film film = two_objects().film;
    film.layer_set = {};
    ASSERT_TRUE(write(film, folder_ / "picture.EXR").empty());
    std::vector<std::string> channels;
    static_cast<void>(read(folder_ / "picture.EXR", &channels));
    EXPECT_EQ(channels, (std::vector<std::string>{"R", "G", "B", "A"}));
}

TEST_F(Output, NoFileContainsNaN) {
    Film film = two_objects().film;
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    film.sum[5] = Color4f(nan, nan, nan, nan);
    film.layers->position[5].x = nan;
    ASSERT_TRUE(write(film, folder_ / "a.png").empty());
    ASSERT_TRUE(write(film, folder_ / "a.exr").empty());
    EXPECT_EQ(read(folder_ / "a.png")[20], 0.0F);
    for (const float value : read(folder_ / "a.exr")) {
        ASSERT_FALSE(std::isnan(value));
    }
}

// The other formats for display hold the pixels of the PNG: TIFF and PNG of 16 bits exactly, WebP
// and JPEG as far as their compression allows, JPEG in front of black.
TEST_F(Output, EveryDisplayFormatShowsTheSamePicture) {
    const Film film = two_objects().film;
    ASSERT_TRUE(write(film, folder_ / "a.png", {-1.0, 16}).empty());
    const std::vector<float> exact = read(folder_ / "a.png");
    for (const DisplayFormat& format : display_formats()) {
        const fs::path file = folder_ / ("b" + std::string(format.extension));
        ASSERT_TRUE(write(film, file, {.exposure = -1.0}).empty()) << file;
        const std::vector<float> values = read(file);
        const std::size_t channels = format.has_alpha ? 4 : 3;
        ASSERT_EQ(values.size(), 37U * 83U * channels) << file;
        const bool lossy = format.encoder == "jpeg" || format.encoder == "webp";
        const double step = 1.0 / ((1 << format.bits) - 1);
        double error = 0.0;
        for (std::size_t i = 0; i < 37 * 83; ++i) {
            // A transparent pixel has no colour.
            if (exact[4 * i + 3] == 1.0F || !format.has_alpha) {
                const float shown = exact[4 * i + 3] > 0.0F && exact[4 * i + 3] < 1.0F
                                        ? values[channels * i]
                                        : exact[4 * i];
                const double difference = std::abs(double{values[channels * i]} - double{shown});
                error += difference / (37 * 83);
                EXPECT_TRUE(lossy || difference <= step) << file << ' ' << i;
            }
        }
        EXPECT_LT(error, 0.01) << file;
    }
}

TEST_F(Output, FilesDoNotTellWhenTheyWereWritten) {
    const Film film = light_and_display();
    for (const DisplayFormat& format : display_formats()) {
        const fs::path file = folder_ / ("a" + std::string(format.extension));
        ASSERT_TRUE(write(film, file).empty()) << file;
        OIIO::ImageSpec spec;
        read(file, nullptr, &spec);
        EXPECT_EQ(spec.find_attribute("DateTime"), nullptr) << file;
    }
}

TEST_F(Output, ExrOfAnyWidthNeedsLittleMemory) {
    Film film = *make_film({.width = max_film_side, .height = 6, .data_layers = false});
    film.passes.assign(film.tile_count(), 1);
    film.sum.back() = Color4d(0.25, 0.5, 1.0, 1.0);
    const ChannelValues values(channel_groups(film));
    EXPECT_EQ(values.rows_at_once(film.width), 4U);
    EXPECT_EQ(values.rows_at_once(64 * film.width), 1U);
    EXPECT_EQ(values.rows_at_once(1), 64U);
    ASSERT_TRUE(write(film, folder_ / "wide.exr").empty());
    EXPECT_EQ(read(folder_ / "wide.exr").at(4 * film.sum.size() - 2), 1.0F);
}

TEST_F(Output, APictureTooLargeForAFormatIsAnError) {
    const DisplayFormat* const webp = display_format("a.WebP");
    ASSERT_NE(webp, nullptr);
    EXPECT_TRUE(check_size(*webp, 16383, 1).empty());
    EXPECT_TRUE(has_errors(check_size(*webp, 1, 16384)));
    EXPECT_EQ(display_format("a.exr"), nullptr);
}

TEST_F(Output, UnwritableFilesAreReportedInAdvance) {
    EXPECT_TRUE(check_output(folder_ / "a.png").empty());
    EXPECT_TRUE(check_output("a.exr").empty());
    EXPECT_TRUE(has_errors(check_output(folder_ / "a.gif")));
    EXPECT_TRUE(has_errors(check_output(folder_ / "a")));
    EXPECT_TRUE(has_errors(check_output(folder_ / "missing" / "a.png")));
    fs::create_directory(folder_ / "b.png");
    EXPECT_TRUE(has_errors(check_output(folder_ / "b.png")));
    const Film film = two_objects().film;
    EXPECT_TRUE(has_errors(write(film, folder_ / "missing" / "a.png")));
    EXPECT_TRUE(has_errors(write(film, folder_ / "missing" / "a.png")));
    EXPECT_TRUE(has_errors(write_exr(film, folder_ / "missing" / "a.exr")));
    EXPECT_TRUE(has_errors(write(film, folder_ / "a.png", {0.0, 12})));
    EXPECT_TRUE(has_errors(write(film, folder_ / "a.jpg", {0.0, 16})));
    EXPECT_EQ(files(), 1U);
}

// A limit on the size of files stands in for a full disk.
TEST_F(Output, AFullDiskLeavesTheOldFileAndNothingElse) {
    const Film film = two_objects().film;
    for (const char* name : {"a.png", "a.exr"}) {
        std::ofstream(folder_ / name) << "old";
        struct rlimit before {};
        ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
        auto* handler = std::signal(SIGXFSZ, SIG_IGN);
        struct rlimit tight = before;
        tight.rlim_cur = 100;
        ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
        const Diagnostics said = write(film, folder_ / name);
        ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
        std::signal(SIGXFSZ, handler);
        EXPECT_TRUE(has_errors(said)) << name;
        std::string text;
        std::ifstream(folder_ / name) >> text;
        EXPECT_EQ(text, "old");
    }
    EXPECT_EQ(files(), 2U);
}

TEST_F(Output, ALinkIsKeptAndItsTargetReplaced) {
    fs::create_directory(folder_ / "real");
    std::ofstream(folder_ / "real" / "a.png") << "old";
    fs::create_symlink(folder_ / "real" / "a.png", folder_ / "a.png");
    ASSERT_TRUE(write(two_objects().film, folder_ / "a.png").empty());
    EXPECT_TRUE(fs::is_symlink(folder_ / "a.png"));
    EXPECT_GT(fs::file_size(folder_ / "real" / "a.png"), 100U);
}

}  // namespace
}  // namespace balcony::render::test::output_test
