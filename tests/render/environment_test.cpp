// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Environments from files and skies, and the light of scenes without light.

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <stop_token>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"
#include "images/luminance.hpp"
#include "shading/lights/light_set.hpp"
#include "support.hpp"

namespace balcony::render::test::environment_test {
namespace {

namespace fs = std::filesystem;

constexpr double degree = std::numbers::pi / 180.0;

// A picture file of three floats per pixel.
class PictureFile {
public:
    PictureFile(const std::string& name, int width, int height, const std::vector<float>& values,
                int orientation = 1)
        : path_(folder_ / name) {
        const auto output = OIIO::ImageOutput::create(path_.string());
        const bool floats = path_.extension() != ".png";
        OIIO::ImageSpec spec(width, height, 3,
                             floats ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
        spec.attribute("Orientation", orientation);
        EXPECT_TRUE(output && output->open(path_.string(), spec) &&
                    output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close());
    }

    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    files::TemporaryFolder folder_;
    fs::path path_;
};

LightSet lit_by(const Environment& environment) {
    static const scene::Scene scene;
    return LightSet(scene).with(environment);
}

TEST(Environment, ReadsFilesOfFloatsAsLight) {
    for (const char* name : {"light.exr", "light.hdr"}) {
        const PictureFile file(name, 2, 1, {1.0F, 2.0F, 4.0F, 8.0F, 8.0F, 8.0F});
        const Result<Environment> read = Environment::load(file.path());
        ASSERT_TRUE(read) << to_text(read.diagnostics);
        EXPECT_TRUE(read.diagnostics.empty()) << to_text(read.diagnostics);
        // The left half is where y is positive if z is up: towards -z in the scene.
        const Color3f left = lit_by(*read).radiance_from({0.0F, 0.0F, -1.0F});
        EXPECT_NEAR(left.x, 1.0F, 0.02F);
        EXPECT_NEAR(left.z, 4.0F, 0.04F);
        EXPECT_NEAR(lit_by(read->scaled(3.0F)).radiance_from({0.0F, 0.0F, 1.0F}).x, 24.0F, 0.2F);
    }
}

TEST(Environment, IsUpright) {
    // What is seen at the left is the first row of the file.
    const PictureFile file("turned.tif", 1, 2, {1.0F, 1.0F, 1.0F, 8.0F, 8.0F, 8.0F}, 8);
    const Result<Environment> read = Environment::load(file.path());
    ASSERT_TRUE(read) << to_text(read.diagnostics);
    EXPECT_EQ(lit_by(*read).radiance_from({0.0F, 0.0F, -1.0F}).x, 1.0F);
    EXPECT_EQ(lit_by(*read).radiance_from({0.0F, 0.0F, 1.0F}).x, 8.0F);
}

// Around the vertical axis, from x towards -z in the scene, as longitudes count.
TEST(Environment, TurnsCounterclockwise) {
    std::vector<float> quarters;
    for (const float radiance : {1.0F, 2.0F, 4.0F, 8.0F}) {
        quarters.insert(quarters.end(), 3, radiance);
    }
    const PictureFile file("quarters.exr", 4, 1, quarters);
    const Result<Environment> read = Environment::load(file.path());
    ASSERT_TRUE(read) << to_text(read.diagnostics);
    const auto radiance = [&](double angle) {
        const V3f at_longitude_45(std::sqrt(0.5F), 0.0F, -std::sqrt(0.5F));
        return lit_by(read->rotated(angle)).radiance_from(at_longitude_45).x;
    };
    EXPECT_NEAR(radiance(0.0), 2.0F, 1e-3F);
    EXPECT_NEAR(radiance(90.0 * degree), 4.0F, 1e-3F);
    EXPECT_NEAR(radiance(-90.0 * degree), 1.0F, 1e-3F);
}

TEST(Environment, DecodesOtherFilesFromSrgb) {
    const PictureFile file("light.png", 1, 2, std::vector<float>(6, 0.5F));
    const Result<Environment> read = Environment::load(file.path());
    ASSERT_TRUE(read) << to_text(read.diagnostics);
    EXPECT_NEAR(lit_by(*read).radiance_from({1.0F, 0.0F, 0.0F}).x, 0.214F, 0.003F);
}

TEST(Environment, ReplacesWhatIsNoLightAndCountsIt) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const PictureFile file(
        "bad.exr", 4, 1,
        {1.0F, 1.0F, 1.0F, nan, 1.0F, 1.0F, -1.0F, 1.0F, -2.0F, 1.0F, infinity, 1.0F});
    const Result<Environment> read = Environment::load(file.path());
    ASSERT_TRUE(read) << to_text(read.diagnostics);
    ASSERT_EQ(read.diagnostics.size(), 1U);
    EXPECT_NE(read.diagnostics[0].message.find("3 pixels"), std::string::npos)
        << read.diagnostics[0].message;
    const LightSet lights = lit_by(*read);
    for (int i = 0; i < 100; ++i) {
        const auto sample = lights.sample({V3f(0.0F), {0.0F, 1.0F, 0.0F}},
                                          V3f(0.5F, 0.01F * static_cast<float>(i), 0.5F));
        ASSERT_TRUE(sample);
        EXPECT_TRUE(std::isfinite(luminance(sample->radiance)) && sample->radiance.x >= 0.0F);
        EXPECT_LE(sample->radiance.y, 65504.0F);
    }
}

TEST(Environment, SaysWhyAFileCannotBeUsed) {
    const Result<Environment> missing = Environment::load("nowhere/meadow.hdr");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.diagnostics[0].message.find("meadow.hdr"), std::string::npos);
    EXPECT_NE(missing.diagnostics[0].message.find("there is no file"), std::string::npos);

    const PictureFile black("black.exr", 2, 1, std::vector<float>(6, 0.0F));
    const Result<Environment> dark = Environment::load(black.path());
    ASSERT_TRUE(dark);
    ASSERT_EQ(dark.diagnostics.size(), 1U);
    EXPECT_NE(dark.diagnostics[0].message.find("black"), std::string::npos);
    EXPECT_FALSE(lit_by(*dark).has_distant());
}

// --------------------------------------------------------------------------------------- skies

float luminance_of_sky(const Sky& sky, const V3f& direction) {
    const Result<Environment> made = Environment::sky(sky);
    EXPECT_TRUE(made);
    return luminance(lit_by(*made).radiance_from(direction.normalized()));
}

TEST(Environment, LoadingObeysAStop) {
    const PictureFile picture("stopped.exr", 2, 1, std::vector<float>(6, 1.0F));
    std::stop_source stop;
    EXPECT_TRUE(Environment::load(picture.path(), stop.get_token()));
    stop.request_stop();
    const auto stopped = Environment::load(picture.path(), stop.get_token());
    EXPECT_FALSE(stopped);
    EXPECT_EQ(kind_of_errors(stopped.diagnostics), Kind::interrupted);
}

TEST(Sky, HasTheLuminanceOfAClearDay) {
    const Sky noon{.elevation = 60.0 * degree, .azimuth = 90.0 * degree, .turbidity = 2.0};
    // Kittler, Perez and Darula (1998) give zeniths of clear skies of 2 to 8 kcd/m².
    const float zenith = luminance_of_sky(noon, {0.0F, 1.0F, 0.0F});
    EXPECT_GT(zenith, 2000.0F);
    EXPECT_LT(zenith, 8000.0F);
    // East is x; the sun's disc gives about 100 klx, so about 1.5e9 cd/m².
    const auto height = static_cast<float>(std::sin(60.0 * degree));
    EXPECT_GT(luminance_of_sky(noon, {0.5F, height, 0.0F}), 1e9F);
    EXPECT_LT(luminance_of_sky(noon, {-0.5F, height, 0.0F}), 1e4F);
    EXPECT_LT(luminance_of_sky(noon, {0.0F, height, 0.5F}), 1e5F);
    const Sky in_the_south{.elevation = 60.0 * degree, .azimuth = 180.0 * degree};
    EXPECT_GT(luminance_of_sky(in_the_south, {0.0F, height, 0.5F}), 1e9F);
}

TEST(Sky, IsBlueAboveAndRedAtSunset) {
    const Result<Environment> noon = Environment::sky({.elevation = 50.0 * degree});
    const Color3f zenith = lit_by(*noon).radiance_from({0.0F, 1.0F, 0.0F});
    EXPECT_GT(zenith.z, 1.2F * zenith.x);
    const Result<Environment> evening =
        Environment::sky({.elevation = 2.0 * degree, .azimuth = 0.0});
    const Color3f glow = lit_by(*evening).radiance_from(V3f(0.0F, 0.05F, -1.0F).normalized());
    EXPECT_GT(glow.x, 1.5F * glow.z);
}

TEST(Sky, DarkensAsTheSunSets) {
    float before = std::numeric_limits<float>::infinity();
    for (const double elevation : {80.0, 40.0, 20.0, 5.0, 0.0, -5.0, -10.0, -15.0}) {
        const float zenith =
            luminance_of_sky({.elevation = elevation * degree}, {-0.1F, 1.0F, 0.1F});
        EXPECT_LT(zenith, before) << elevation;
        before = zenith;
    }
}

TEST(Sky, RefusesWhatIsOutOfRange) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Sky& sky :
         {Sky{.elevation = 2.0}, Sky{.elevation = -1.0}, Sky{.elevation = nan}, Sky{.azimuth = nan},
          Sky{.turbidity = 0.5}, Sky{.turbidity = 11.0}, Sky{.turbidity = nan}}) {
        EXPECT_FALSE(Environment::sky(sky));
    }
}

// ----------------------------------------------------------------------- scenes without light

std::string light_of(const scene::Scene& scene, const Settings& settings = {}) {
    Request wanted = request(32, 32, "path", 4);
    wanted.ambient = settings.ambient;
    wanted.light = settings.light;
    return render(scene, pinhole(view_down_z(0.0, 0.0, 1.0)), wanted).summary.light;
}

// A box of side 4 around the origin, without its ceiling if it is open.
scene::Scene room(bool open) {
    scene::Scene scene;
    scene.default_light = true;
    const auto side = [&](V3f corner, V3f right, V3f up) {
        add(scene, parallelogram(corner, right, up), white());
    };
    side({-2, -2, -2}, {4, 0, 0}, {0, 4, 0});
    side({-2, -2, 2}, {4, 0, 0}, {0, 4, 0});
    side({-2, -2, -2}, {0, 0, 4}, {0, 4, 0});
    side({2, -2, -2}, {0, 0, 4}, {0, 4, 0});
    side({-2, -2, -2}, {4, 0, 0}, {0, 0, 4});
    if (!open) {
        side({-2, 2, -2}, {4, 0, 0}, {0, 0, 4});
    }
    return scene;
}

TEST(DefaultLight, IsASkyWhereOneCanBeSeen) {
    EXPECT_NE(light_of(room(true)).find("sky"), std::string::npos) << light_of(room(true));
}

TEST(DefaultLight, IsAtTheEyeInAClosedRoom) {
    EXPECT_NE(light_of(room(false)).find("eye"), std::string::npos) << light_of(room(false));
}

TEST(DefaultLight, GivesWayToAnyOther) {
    Settings settings;
    settings.ambient = Color3f(0.5F);
    EXPECT_NE(light_of(room(true), settings).find("constant"), std::string::npos);
    settings.ambient.reset();
    settings.light.environment = *Environment::sky({});
    EXPECT_NE(light_of(room(false), settings).find("sun"), std::string::npos);
    scene::Scene lamp = room(true);
    lamp.default_light = false;
    lamp.lights.emplace_back();
    EXPECT_EQ(light_of(lamp), "1 lamp");
}

// A white floor has the sky's irradiance over pi, which is the integral of twice the luminance
// (0.75 + 0.375 h) (0.966 - 0.048 h) and h over the height h from 0 to 1: 0.93.
TEST(DefaultLight, ShowsAFloorInItsColour) {
    scene::Scene scene;
    scene.default_light = true;
    add(scene, parallelogram({-9.0F, 0.0F, 9.0F}, {18.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -18.0F}),
        white());
    Request wanted = request(16, 16, "path", 64);
    wanted.ambient.reset();
    const View from_above{{0.0, 1.0, 0.0}, {0.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}};
    const Film film = render(scene, orthographic(from_above), wanted).film;
    double sum = 0.0;
    for (std::size_t i = 0; i < 256; ++i) {
        sum += double{luminance(film.pixel(i % 16, i / 16))} / 256.0;
    }
    EXPECT_NEAR(sum, 0.93, 0.01);
}

// The walls of a room light each other. If they took no light at all, a closed room would become
// the brighter, the more bounces are allowed.
TEST(DefaultLight, MakesAPictureOfMediumBrightness) {
    const auto brightness = [](scene::Scene scene) {
        for (scene::Material& material : scene.materials) {
            material.base_color = Color3f(0.8F);
        }
        Request wanted = request(32, 32, "path", 16);
        wanted.ambient.reset();
        const Rendered made = render(scene, pinhole(view_down_z(0.0, 0.0, 1.0)), wanted);
        double sum = 0.0;
        for (std::size_t y = 0; y < 32; ++y) {
            for (std::size_t x = 0; x < 32; ++x) {
                sum += double{luminance(made.film.pixel(x, y))} / 1024.0;
            }
        }
        return sum;
    };
    for (const bool open : {true, false}) {
        EXPECT_GT(brightness(room(open)), 0.3);
        EXPECT_LT(brightness(room(open)), 12.0);
    }
}

}  // namespace
}  // namespace balcony::render::test::environment_test
