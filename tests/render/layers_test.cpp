// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The layers of a film: their table, and the laws that hold between them.

#include "balcony/layers.hpp"

#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "balcony/layer_values.hpp"
#include "balcony/picture.hpp"
#include "film/sums/cryptomatte.hpp"
#include "film/sums/layer_rows.hpp"
#include "support.hpp"

namespace balcony::render::test::layers_test {
namespace {

LayerSet all_layers() { return *find_layers("all"); }

std::array<float, 12> read(const Film& film, LayerId id, std::size_t x, std::size_t y) {
    std::array<float, 12> channels{};
    const LayerRow& row = layer_rows()[static_cast<std::size_t>(id)];
    EXPECT_TRUE(row.complete(film)) << row.info.name;
    row.read(film, x, y, channels.data());
    return channels;
}

Request with_layers(Request made, LayerSet wanted) {
    made.layout.layers = wanted;
    return made;
}

// ------------------------------------------------------------------------------------- table

TEST(LayerTable, HasNamesAndChannelsThatOtherProgramsRead) {
    std::set<std::string_view> names;
    for (const LayerInfo& layer : layers()) {
        EXPECT_TRUE(names.insert(layer.name).second) << layer.name;
        EXPECT_FALSE(layer.meaning.empty()) << layer.name;
        const std::size_t count = layer.channels.size();
        EXPECT_TRUE(count == 1 || count == 3 || count == 4) << layer.name;
        EXPECT_EQ(std::set<char>(layer.channels.begin(), layer.channels.end()).size(), count);
    }
}

TEST(LayerTable, FindsListsOfNames) {
    EXPECT_EQ(*find_layers("default"), default_layers());
    EXPECT_EQ(*find_layers("none"), LayerSet{});
    EXPECT_EQ(*find_layers("direct,CryptoObject"),
              (LayerSet{LayerId::direct, LayerId::crypto_object}));
    EXPECT_TRUE(find_layers("all")->contains(LayerId::variance));
    EXPECT_FALSE(find_layers("all")->contains(LayerId::noisy));
    for (const char* wrong : {"", "direct,", "directt", "noisy", "Direct", "direct indirect"}) {
        const Result<LayerSet> found = find_layers(wrong);
        EXPECT_TRUE(!found && has_errors(found.diagnostics)) << wrong;
    }
    EXPECT_NE(to_text(find_layers("directt").diagnostics).find("'direct'?"), std::string::npos);
    EXPECT_NE(to_text(find_layers("noisy").diagnostics).find("denoised"), std::string::npos);
}

// docs/layers.md lists every layer with what the table says.
TEST(LayerTable, IsDocumented) {
    std::ifstream page(BALCONY_SOURCE_DIR "/docs/layers.md");
    std::stringstream text;
    text << page.rdbuf();
    for (const LayerInfo& layer : layers()) {
        std::string channels;
        for (const char letter : layer.channels) {
            channels += fmt::format("{}`{}.{}`", channels.empty() ? "" : " ",
                                    channels.empty() ? layer.name : "", letter);
        }
        const std::string row = fmt::format(
            "| {} | {} | {} | {} | {} |",
            layer.levels > 1 ? fmt::format("`{0}00.R` … `{0}02.A`", layer.name) : channels,
            layer.meaning,
            layer.sampling == LayerSampling::center ? "centre"
            : layer.sampling == LayerSampling::mean ? "mean"
                                                    : "",
            layer.by_default ? "yes" : "", layer.bytes);
        EXPECT_NE(text.str().find(row), std::string::npos) << row;
    }
}

TEST(LayerTable, AFilmHasExactlyTheLayersAskedFor) {
    const Film film = *make_film({.width = 5,
                                  .height = 4,
                                  .data_layers = false,
                                  .layers = {LayerId::position, LayerId::indirect}});
    EXPECT_EQ(film.layers->position.size(), 20U);
    EXPECT_EQ(film.layers->valid.size(), 20U);
    EXPECT_TRUE(film.layers->normal.empty());
    EXPECT_EQ(film.means.direct.size(), 20U) << "from which indirect light is computed";
    EXPECT_TRUE(film.means.albedo.empty());
    EXPECT_FALSE(make_film({.width = 5, .height = 4, .data_layers = false})->layers);
}

TEST(LayerValues, AreThoseOfTheWindowRowByRow) {
    Film film = *make_film({.width = 9,
                            .height = 7,
                            .window = Region{2, 3, 5, 4},
                            .layers = {LayerId::crypto_object}});
    for (std::size_t i = 0; i < 20; ++i) {
        film.layers->normal[i] = V3f(static_cast<float>(i), 0.5F, -1.0F);
        film.sum[i] = Color4d(3.0 * static_cast<double>(i), 0.0, 6.0, 3.0);
    }
    std::fill(film.passes.begin(), film.passes.end(), 3U);
    const auto normals = layer_values(film, LayerId::normal);
    ASSERT_TRUE(normals);
    ASSERT_EQ(normals->channels, 3U);
    ASSERT_EQ(normals->values.size(), 60U);
    const LayerValues color = color_values(film);
    ASSERT_EQ(color.channels, 4U);
    for (std::size_t i = 0; i < 20; ++i) {
        EXPECT_EQ(normals->values[3 * i], static_cast<float>(i));
        EXPECT_EQ(normals->values[3 * i + 2], -1.0F);
        EXPECT_EQ(color.values[4 * i], static_cast<float>(i));
        EXPECT_EQ(color.values[4 * i + 2], 2.0F);
    }
    const std::size_t levels = layers()[static_cast<std::size_t>(LayerId::crypto_object)].levels;
    EXPECT_EQ(layer_values(film, LayerId::crypto_object)->channels, 4 * levels);
    const auto none = layer_values(film, LayerId::motion);
    EXPECT_EQ(kind_of_errors(none.diagnostics), Kind::usage);
}

// ------------------------------------------------------------------------------------- light

// An orthographic view of a lamp (left) and a white wall (right), which a point light illuminates.
Rendered lamp_and_wall(const Request& wanted) {
    scene::Scene scene;
    scene::Material lamp = white();
    lamp.base_color = Color3f(0.0F);
    lamp.emission = Color3f(3.0F, 2.0F, 1.0F);
    add(scene, parallelogram({-1.0F, -1.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 2.0F, 0.0F}), lamp);
    scene::Material wall = white();
    wall.name = "paint";
    add(scene, parallelogram({0.0F, -1.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 2.0F, 0.0F}), wall);
    scene::Light light;
    light.position = scene::V3d(0.5, 0.0, 1.0);
    light.intensity = Color3f(2.0F);
    scene.lights.push_back(light);
    return render(scene, orthographic(view_down_z(0.0, 0.0, 2.0)), wanted);
}

TEST(LightLayers, SeparateEmissionDirectAndAmbientLight) {
    Request wanted = with_layers(request(32, 32, "direct", 3), all_layers());
    wanted.ambient = Color3f(0.25F);
    const Film film = lamp_and_wall(wanted).film;
    for (const std::size_t y : {4U, 16U, 30U}) {
        for (const std::size_t x : {4U, 28U}) {
            const auto emission = read(film, LayerId::emission, x, y);
            const auto direct = read(film, LayerId::direct, x, y);
            const auto indirect = read(film, LayerId::indirect, x, y);
            const Color4f picture = film.pixel(x, y);
            EXPECT_NEAR(emission[0], x < 16 ? 3.0F : 0.0F, 1e-6F);
            EXPECT_NEAR(emission[2], x < 16 ? 1.0F : 0.0F, 1e-6F);
            EXPECT_NEAR(emission[0] + direct[0] + indirect[0], picture.r, 1e-6F);
            if (x >= 16) {
                // The ambient light of a white, fully rough surface.
                EXPECT_NEAR(indirect[1], 0.25F, 0.02F);
                EXPECT_NEAR(direct[1], picture.g - 0.25F, 0.02F);
                EXPECT_GT(direct[1], 0.1F);
            }
        }
    }
}

// In a picture without a second reflection, the path integrator's direct light is all there is.
TEST(LightLayers, OfThePathIntegratorAddUp) {
    Request wanted = with_layers(request(32, 32, "path", 8), all_layers());
    const Film film = lamp_and_wall(wanted).film;
    for (std::size_t i = 0; i < 32 * 32; ++i) {
        const std::size_t x = i % 32;
        const std::size_t y = i / 32;
        const auto emission = read(film, LayerId::emission, x, y);
        const auto direct = read(film, LayerId::direct, x, y);
        const auto indirect = read(film, LayerId::indirect, x, y);
        // Both parts are flat and face the same way, so neither lights the other.
        ASSERT_NEAR(indirect[0], 0.0F, 1e-5F) << i;
        ASSERT_NEAR(emission[0] + direct[0], film.pixel(x, y).r, 1e-5F) << i;
    }
}

// ----------------------------------------------------------------------------- means over passes

TEST(MeanLayers, AreFilteredLikeThePicture) {
    const Film film = lamp_and_wall(with_layers(request(32, 32, "preview", 64), all_layers())).film;
    // Pixels away from the edge between the objects have the values of their centres.
    EXPECT_NEAR(read(film, LayerId::mean_albedo, 28, 9)[0], 1.0F, 1e-6F);
    EXPECT_EQ(read(film, LayerId::mean_albedo, 3, 9)[0], 0.0F);
    EXPECT_NEAR(read(film, LayerId::mean_normal, 28, 9)[2], 1.0F, 1e-6F);
    const auto at_center = read(film, LayerId::position, 28, 9);
    const auto mean = read(film, LayerId::mean_position, 28, 9);
    EXPECT_NEAR(mean[0], at_center[0], 0.02F);
    EXPECT_EQ(read(film, LayerId::samples, 28, 9)[0], 64.0F);
    // At the edge, the albedo is between.
    EXPECT_GT(read(film, LayerId::mean_albedo, 16, 9)[0], 0.5F);
    EXPECT_LT(read(film, LayerId::mean_albedo, 15, 9)[0], 0.5F);
    EXPECT_GT(read(film, LayerId::mean_albedo, 15, 9)[0], 0.0F);
}

// A pane shows the red wall behind it, a mirror the green wall behind the viewer.
TEST(MeanLayers, AreThoseOfWhatMirrorsAndGlassShow) {
    scene::Scene scene;
    const auto wall = [&](V3f corner, V3f right, V3f up, const scene::Material& material) {
        add(scene, parallelogram(corner, right, up), material);
    };
    scene::Material pane = white();
    pane.roughness = 0.0F;
    pane.transmission = 1.0F;
    pane.thin_walled = true;
    scene::Material mirror = white();
    mirror.roughness = 0.0F;
    mirror.metallic = 1.0F;
    scene::Material red = white();
    red.base_color = Color3f(1.0F, 0.0F, 0.0F);
    scene::Material green = white();
    green.base_color = Color3f(0.0F, 1.0F, 0.0F);
    const V3f x(1.0F, 0.0F, 0.0F);
    const V3f y(0.0F, 2.0F, 0.0F);
    wall({-1.0F, -1.0F, 0.0F}, x, y, pane);
    wall({0.0F, -1.0F, 0.0F}, x, y, mirror);
    wall({-1.0F, -1.0F, -1.0F}, x, y, red);
    wall({1.0F, -1.0F, 9.0F}, -x, y, green);
    const Film film = render(scene, orthographic(view_down_z(0.0, 0.0, 1.0)),
                             with_layers(request(8, 8, "path", 64), all_layers()))
                          .film;
    EXPECT_GT(read(film, LayerId::mean_albedo, 1, 4)[0], 0.5F);
    EXPECT_EQ(read(film, LayerId::mean_albedo, 1, 4)[1], 0.0F);
    EXPECT_LT(read(film, LayerId::mean_position, 1, 4)[2], -0.5F);
    EXPECT_EQ(read(film, LayerId::mean_albedo, 6, 4)[0], 0.0F);
    EXPECT_NEAR(read(film, LayerId::mean_albedo, 6, 4)[1], 1.0F, 1e-6F);
    EXPECT_NEAR(read(film, LayerId::mean_normal, 6, 4)[2], -1.0F, 1e-6F);
    // The data of the pixel's centre are those of the surface itself.
    EXPECT_EQ(read(film, LayerId::albedo, 1, 4)[1], 1.0F);
    EXPECT_EQ(read(film, LayerId::position, 6, 4)[2], 0.0F);
}

// Whichever way a path goes, a pane shows the same: the red wall behind it, and a little of the
// green one behind the viewer.
TEST(MeanLayers, OfGlassHaveNoNoise) {
    scene::Scene scene;
    const V3f x(2.0F, 0.0F, 0.0F);
    const V3f y(0.0F, 2.0F, 0.0F);
    const auto wall = [&](V3f corner, V3f right, Color3f color) {
        scene::Material material = white();
        material.base_color = color;
        add(scene, parallelogram(corner, right, y), material);
    };
    scene::Material pane = white();
    pane.roughness = 0.0F;
    pane.transmission = 1.0F;
    pane.thin_walled = true;
    add(scene, parallelogram({-1.0F, -1.0F, 0.0F}, x, y), pane);
    wall({-1.0F, -1.0F, -1.0F}, x, {1.0F, 0.0F, 0.0F});
    wall({1.0F, -1.0F, 9.0F}, -x, {0.0F, 1.0F, 0.0F});
    const Film film = render(scene, orthographic(view_down_z(0.0, 0.0, 1.0)),
                             with_layers(request(8, 8, "path", 4), all_layers()))
                          .film;
    for (std::size_t pixel = 0; pixel < 8; ++pixel) {
        const float passed = read(film, LayerId::mean_albedo, pixel, 4)[0];
        const float mirrored = read(film, LayerId::mean_albedo, pixel, 4)[1];
        EXPECT_NEAR(passed + mirrored, 1.0F, 1e-5F);
        EXPECT_GT(mirrored, 0.03F);
        EXPECT_LT(mirrored, 0.1F);
        EXPECT_NEAR(mirrored, read(film, LayerId::mean_albedo, 0, 0)[1], 1e-6F);
        EXPECT_NEAR(read(film, LayerId::mean_normal, pixel, 4)[2], passed - mirrored, 1e-5F);
        EXPECT_NEAR(read(film, LayerId::mean_position, pixel, 4)[2], 9.0F * mirrored - passed,
                    1e-4F);
    }
}

// No path ends by chance at a grey mirror before it finds what the mirror shows.
TEST(MeanLayers, OfMirrorsHaveNoNoise) {
    scene::Scene scene;
    scene::Material mirror = white();
    mirror.base_color = Color3f(0.3F);
    mirror.roughness = 0.0F;
    mirror.metallic = 1.0F;
    const V3f y(0.0F, 2.0F, 0.0F);
    add(scene, parallelogram({-1.0F, -1.0F, 0.0F}, {2.0F, 0.0F, 0.0F}, y), mirror);
    add(scene, parallelogram({1.0F, -1.0F, 9.0F}, {-2.0F, 0.0F, 0.0F}, y), white());
    const Film film = render(scene, orthographic(view_down_z(0.0, 0.0, 1.0)),
                             with_layers(request(8, 8, "path", 4), all_layers()))
                          .film;
    for (std::size_t pixel = 0; pixel < 8; ++pixel) {
        EXPECT_NEAR(read(film, LayerId::mean_normal, pixel, 4)[2], -1.0F, 1e-6F);
    }
}

TEST(MeanLayers, MomentsAreThoseOfTheSamples) {
    Moments moments;
    const float samples[] = {1000.5F, 1000.25F, 1001.0F, 999.75F};
    for (std::uint32_t i = 0; i < 4; ++i) {
        moments.add(V3f(samples[i], 0.0F, 1.0F), i + 1);
    }
    EXPECT_NEAR(moments.mean.x, 1000.375F, 1e-4F);
    EXPECT_NEAR(moments.squares.x, 0.8125F, 1e-3F);
    EXPECT_EQ(moments.squares.z, 0.0F);
}

// The variance of a pixel's mean falls as one over the number of samples, and its root is the
// error.
TEST(MeanLayers, VarianceIsThatOfThePicture) {
    Film film =
        *make_film({.width = 1, .height = 1, .data_layers = false, .layers = {LayerId::variance}});
    film.passes = {4};
    film.sum = {Color4d(8.0, 0.0, 4.0, 4.0)};  // 1, 2, 3, 2; and constant 0 and 1.
    film.sum_of_squares = {Color4d(18.0, 0.0, 4.0, 4.0)};
    const auto variance = read(film, LayerId::variance, 0, 0);
    EXPECT_NEAR(variance[0], (2.0F / 3.0F) / 4.0F, 1e-6F);
    EXPECT_EQ(variance[1], 0.0F);
    EXPECT_EQ(variance[2], 0.0F);
}

// The first half is what a film with so many samples has.
TEST(MeanLayers, HalvesAreTheFirstSamples) {
    const auto direct = [](std::size_t samples, LayerId id) {
        const Film film =
            lamp_and_wall(with_layers(request(16, 16, "path", samples), all_layers())).film;
        return read(film, id, 12, 5)[1];
    };
    for (const auto& [samples, half] : std::map<std::size_t, std::size_t>{
             {2, 1}, {3, 2}, {4, 2}, {5, 2}, {6, 4}, {8, 4}, {9, 4}, {11, 4}, {12, 8}, {16, 8}}) {
        const float first = direct(half, LayerId::direct);
        EXPECT_NE(first, direct(samples, LayerId::direct)) << samples;
        EXPECT_NEAR(direct(samples, LayerId::direct_half), first, 1e-6F) << samples;
        EXPECT_NEAR(direct(samples, LayerId::indirect_half), 0.0F, 1e-6F);
    }
}

// ------------------------------------------------------------------------------- magnification

TEST(Magnification, IsPixelsPerUnitAcrossTheRay) {
    scene::Scene scene;
    add(scene, wall(-4.0F, 40.0F), white());
    const LayerSet wanted{LayerId::magnification, LayerId::ray_length};
    const Film flat = render(scene, orthographic(view_down_z(0.0, 0.0, 0.0)),
                             with_layers(request(50, 50, "preview"), wanted))
                          .film;
    // 50 pixels for two units, whatever the distance.
    EXPECT_NEAR(flat.layers->magnification[0], 25.0F, 1e-3F);
    EXPECT_NEAR(flat.layers->magnification[1275], 25.0F, 1e-3F);
    const Film film = render(scene, pinhole(view_down_z(0.0, 0.0, 0.0)),
                             with_layers(request(51, 51, "preview"), wanted))
                          .film;
    for (const std::size_t i : {25 * 51 + 25, 25 * 51 + 50, 0}) {
        // The solid angle of a pixel of a plane at distance 1 is its area times the third power of
        // the cosine.
        const float length = film.layers->ray_length[i];
        const float cosine = 4.0F / length;
        EXPECT_NEAR(film.layers->magnification[i], 25.5F / length / std::pow(cosine, 1.5F), 1e-3F)
            << i;
    }
}

TEST(Magnification, IsZeroWhereNothingIsHit) {
    const Film film = render({}, pinhole(view_down_z(0.0, 0.0, 0.0)),
                             with_layers(request(3, 3, "preview"), {LayerId::magnification}))
                          .film;
    EXPECT_EQ(film.layers->magnification, std::vector<float>(9, 0.0F));
}

// -------------------------------------------------------------------------------- Cryptomatte

// Published values of MurmurHash3_x86_32 with the seed 0.
TEST(Cryptomatte, HashesNames) {
    EXPECT_EQ(matte_hash(""), 0U);
    EXPECT_EQ(matte_hash("test"), 0xba6bd213U);
    EXPECT_EQ(matte_hash("hello"), 0x248bfa47U);
    EXPECT_EQ(matte_hash("hello, world"), 0x149bbb7fU);
    EXPECT_EQ(matte_hash("The quick brown fox jumps over the lazy dog"), 0x2e4ff723U);
}

TEST(Cryptomatte, FloatsAreNormal) {
    EXPECT_EQ(std::bit_cast<std::uint32_t>(matte_float(0x248bfa47U)), 0x248bfa47U);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(matte_float(0x7f912345U)), 0x7f112345U);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(matte_float(0x80012345U)), 0x80812345U);
}

TEST(Cryptomatte, ManifestNamesEveryHash) {
    const std::vector<std::string> names{"hello", "a \"b\"\n", "", "hello"};
    const auto attributes = matte_attributes("CryptoObject", names);
    ASSERT_EQ(attributes.size(), 4U);
    const std::string prefix = attributes.begin()->first.substr(0, 20);
    EXPECT_EQ(prefix, fmt::format("cryptomatte/{:07x}/", matte_hash("CryptoObject") >> 4));
    EXPECT_EQ(attributes.at(prefix + "name"), "CryptoObject");
    const std::string& manifest = attributes.at(prefix + "manifest");
    EXPECT_NE(manifest.find("\"hello\":\"248bfa47\""), std::string::npos) << manifest;
    EXPECT_NE(manifest.find("\"a \\\"b\\\"\\u000a\":"), std::string::npos) << manifest;
    EXPECT_NE(manifest.find("\"3\":"), std::string::npos) << "a nameless object has its id";
    EXPECT_EQ(manifest.front(), '{');
    EXPECT_EQ(manifest.back(), '}');
}

std::map<float, float> coverages(const Film& film, LayerId id, std::size_t x, std::size_t y) {
    std::map<float, float> found;
    const auto channels = read(film, id, x, y);
    for (std::size_t rank = 0; rank < 6; ++rank) {
        if (channels[2 * rank] != 0.0F) {
            found[channels[2 * rank]] = channels[2 * rank + 1];
        }
        if (rank > 0) {
            EXPECT_LE(channels[2 * rank + 1], channels[2 * rank - 1]) << "ranks are sorted";
        }
    }
    return found;
}

TEST(Cryptomatte, CoverageIsTheShareOfThePixel) {
    const Film film = lamp_and_wall(with_layers(request(32, 32, "preview", 64), all_layers())).film;
    const float lamp = matte_float(matte_hash("object 0"));
    const float wall = matte_float(matte_hash("object 1"));
    const float paint = matte_float(matte_hash("paint"));
    EXPECT_EQ(coverages(film, LayerId::crypto_object, 3, 9), (std::map{std::pair(lamp, 1.0F)}));
    EXPECT_EQ(coverages(film, LayerId::crypto_material, 28, 9), (std::map{std::pair(paint, 1.0F)}));
    const auto edge = coverages(film, LayerId::crypto_object, 16, 9);
    ASSERT_EQ(edge.size(), 2U);
    EXPECT_NEAR(edge.at(lamp) + edge.at(wall), 1.0F, 1e-6F);
    // The albedo of the lamp is 0 and that of the wall 1.
    EXPECT_NEAR(edge.at(wall), read(film, LayerId::mean_albedo, 16, 9)[0], 1e-5F);
}

TEST(Cryptomatte, KeepsTheLargestOfManyCoverages) {
    Matte matte;
    for (std::uint32_t round = 0; round < 10; ++round) {
        for (std::uint32_t id = 1; id <= 5; ++id) {
            matte.add(id, 1.0F);
        }
        matte.add(100 + round, 0.5F);
    }
    const std::vector<std::string> names{"a", "b", "c", "d", "e"};
    std::array<float, 12> channels{};
    read_matte(matte, names, 10, channels.data());
    for (std::size_t rank = 0; rank < 5; ++rank) {
        EXPECT_EQ(channels[2 * rank + 1], 1.0F);
    }
    EXPECT_LT(channels[11], 0.1F);
    matte.add(200, 0.75F);
    matte.add(201, 0.25F);
    read_matte(matte, names, 10, channels.data());
    EXPECT_EQ(channels[10], matte_float(matte_hash("200")));
    EXPECT_EQ(channels[11], 0.075F);
}

// A layer of 30 % in front of another one has 30 % of each mean, and of the matte.
TEST(Cryptomatte, LayersOfAPictureShareAPixel) {
    scene::Scene scene;
    add(scene, parallelogram({-1.0F, -1.0F, 0.0F}, {2.0F, 0.0F, 0.0F}, {0.0F, 2.0F, 0.0F}),
        white());
    scene::Material red = white();
    red.base_color = Color3f(1.0F, 0.0F, 0.0F);
    add(scene, parallelogram({9.0F, -1.0F, 0.0F}, {2.0F, 0.0F, 0.0F}, {0.0F, 2.0F, 0.0F}), red);
    camera::Layer below{"below", orthographic(view_down_z(0.0, 0.0, 1.0))};
    camera::Layer above{"above", orthographic(view_down_z(10.0, 0.0, 1.0))};
    above.alpha = 0.3;
    camera::Picture::Parts parts;
    parts.name = "both";
    parts.layers = {below, above};
    const auto picture = camera::Picture::make(std::move(parts));
    ASSERT_TRUE(picture);
    const Film film =
        render(scene, *picture, with_layers(request(8, 8, "preview", 2), all_layers())).film;
    const auto shares = coverages(film, LayerId::crypto_object, 4, 4);
    EXPECT_NEAR(shares.at(matte_float(matte_hash("object 0"))), 0.7F, 1e-6F);
    EXPECT_NEAR(shares.at(matte_float(matte_hash("object 1"))), 0.3F, 1e-6F);
    EXPECT_NEAR(read(film, LayerId::mean_albedo, 4, 4)[1], 0.7F, 1e-6F);
    EXPECT_NEAR(read(film, LayerId::direct, 4, 4)[1], film.pixel(4, 4).g, 1e-6F);
}

}  // namespace
}  // namespace balcony::render::test::layers_test
