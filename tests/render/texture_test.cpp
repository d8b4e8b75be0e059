// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Textures: which way up, how filtered, what happens without.

#include <cmath>
#include <filesystem>
#include <numeric>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"
#include "support.hpp"

namespace balcony::render::test::texture_test {
namespace {

using Pixel = std::vector<std::uint8_t>;

// Half a step of 8 bits on its way through a half float of 11 bits.
constexpr float texel_rounding = 1.0F / 255.0F;

Pixel checker(int x, int y) { return (x + y) % 2 == 0 ? Pixel{255, 255, 255} : Pixel{0, 0, 0}; }

scene::Scene textured_wall(std::vector<std::uint8_t> png, float half = 1.0F) {
    scene::Scene scene;
    scene::Material material = white();
    material.base_color_texture.index = add_texture(scene, std::move(png));
    add(scene, wall(0.0F, half), material);
    return scene;
}

TEST(Texture, CornersOfTheImageAreCornersOfThePicture) {
    const scene::Scene scene = textured_wall(encode_png(64, 64, 3, [](int x, int y) {
        return Pixel{static_cast<std::uint8_t>(x < 32 ? 0 : 255),
                     static_cast<std::uint8_t>(y < 32 ? 0 : 255), 255};
    }));
    const Rendered picture =
        render(scene, orthographic(view_down_z(0.0, 0.0, 1.0)), request(64, 64, "preview"));
    for (const std::size_t y : {10U, 50U}) {
        for (const std::size_t x : {10U, 50U}) {
            EXPECT_EQ(picture.film.pixel(x, y),
                      Color4f(x < 32 ? 0.0F : 1.0F, y < 32 ? 0.0F : 1.0F, 1.0F, 1.0F))
                << x << ' ' << y;
        }
    }
}

TEST(Texture, ColourIsDecodedFromSrgbAndMultipliedWithTheFactor) {
    scene::Scene scene = textured_wall(encode_png(16, 16, 3, [](int, int) {
        return Pixel{188, 128, 64};
    }));
    scene.materials[0].base_color = Color3f(0.5F);
    const Rendered picture =
        render(scene, orthographic(view_down_z(0.0, 0.0, 1.0)), request(4, 4, "preview"));
    const auto linear = [](float code) {
        return 0.5F * std::pow((code / 255.0F + 0.055F) / 1.055F, 2.4F);
    };
    EXPECT_NEAR(picture.film.pixel(1, 1).r, linear(188.0F), texel_rounding);
    EXPECT_NEAR(picture.film.pixel(1, 1).g, linear(128.0F), texel_rounding);
    EXPECT_NEAR(picture.film.layers->albedo[5].z, linear(64.0F), texel_rounding);
}

// A view whose pixel centres fall onto no texel's border, where a look-up without filter would be
// grey too.
View unaligned_view() { return view_down_z(0.0013, 0.0009, 1.0); }

// 512 x 512 texels in few pixels: each pixel sees half white, half black, also at the border, also
// where its footprint is long in one direction only.
// The colours of the corners blend linearly over the triangles.
TEST(Texture, VertexColorsAreAFactor) {
    scene::Scene scene;
    add(scene, wall(-2.0F, 1.0F), white());
    scene.materials[0].base_color = Color3f(0.5F);
    scene.meshes[0].edit().colors = {{0.0F, 0.0F, 0.0F, 1.0F},
                                     {1.0F, 0.0F, 0.0F, 1.0F},
                                     {1.0F, 1.0F, 0.0F, 1.0F},
                                     {0.0F, 1.0F, 0.0F, 1.0F}};
    const Rendered picture =
        render(scene, orthographic(view_down_z(0.0, 0.0, 1.0)), request(16, 16, "preview"));
    for (const std::size_t y : {2U, 12U}) {
        for (const std::size_t x : {3U, 9U}) {
            const Color3f albedo = picture.film.layers->albedo[picture.film.index(x, y)];
            // Single rounding of the position.
            EXPECT_NEAR(albedo.x, 0.5F * (static_cast<float>(x) + 0.5F) / 16.0F, 1e-5F);
            EXPECT_NEAR(albedo.y, 0.5F * (15.5F - static_cast<float>(y)) / 16.0F, 1e-5F);
            EXPECT_EQ(albedo.z, 0.0F);
        }
    }
}

TEST(Texture, AFineCheckerFromAfarIsGrey) {
    const scene::Scene scene = textured_wall(encode_png(512, 512, 3, checker));
    for (const auto& [width, height] :
         {std::pair(16, 16), std::pair(16, 400), std::pair(400, 16)}) {
        const auto columns = static_cast<std::size_t>(width);
        const auto rows = static_cast<std::size_t>(height);
        const Rendered picture =
            render(scene, orthographic(unaligned_view()), request(columns, rows, "preview"));
        for (std::size_t i = 0; i < columns * rows; ++i) {
            ASSERT_NEAR(picture.film.pixel(i % columns, i / columns).r, 0.5F, texel_rounding)
                << width << ' ' << height << ' ' << i;
        }
    }
}

// Only the footprint's long side is blurred: stripes along it stay.
TEST(Texture, FilteringIsAnisotropic) {
    const scene::Scene scene = textured_wall(encode_png(256, 256, 3, [](int x, int) {
        return (x / 16) % 2 == 0 ? Pixel{255, 255, 255} : Pixel{0, 0, 0};
    }));
    View wide = view_down_z(0.0, 0.0, 1.0);
    const Rendered picture = render(scene, orthographic(wide), request(256, 16, "preview"));
    for (std::size_t stripe = 0; stripe < 16; ++stripe) {
        EXPECT_NEAR(picture.film.pixel(16 * stripe + 8, 7).r, stripe % 2 == 0 ? 1.0F : 0.0F, 0.1F)
            << stripe;
    }
}

TEST(Texture, AMagnifiedEdgeStaysWithinATexel) {
    const scene::Scene scene = textured_wall(encode_png(8, 8, 3, [](int x, int) {
        return x < 4 ? Pixel{255, 255, 255} : Pixel{0, 0, 0};
    }));
    const Rendered picture =
        render(scene, orthographic(view_down_z(0.0, 0.0, 1.0)), request(800, 4, "preview"));
    // A texel is 100 pixels wide; bilinear filtering goes from centre to centre.
    EXPECT_EQ(picture.film.pixel(345, 1).r, 1.0F);
    EXPECT_EQ(picture.film.pixel(455, 1).r, 0.0F);
}

TEST(Texture, FootprintsInAMirrorAreThoseOfTheReflectedRays) {
    scene::Scene scene;
    scene::Material mirror = white();
    mirror.metallic = 1.0F;
    mirror.roughness = 0.0F;
    add(scene, wall(-2.0F, 10.0F), mirror);
    scene::Material screen;
    screen.base_color = Color3f(0.0F);
    screen.emission = Color3f(1.0F);
    screen.emission_texture.index = add_texture(scene, encode_png(512, 512, 3, checker));
    add(scene, wall(3.0F, 2.0F), screen);
    const Rendered picture =
        render(scene, orthographic(unaligned_view()), request(16, 16, "direct"));
    for (std::size_t i = 0; i < 256; ++i) {
        EXPECT_NEAR(picture.film.pixel(i % 16, i / 16).r, 0.5F, texel_rounding) << i;
    }
}

TEST(Texture, AlphaCutsOut) {
    scene::Scene scene = textured_wall(encode_png(64, 64, 4, [](int x, int) {
        return Pixel{255, 255, 255, static_cast<std::uint8_t>(x < 32 ? 255 : 0)};
    }));
    scene.materials[0].alpha_mode = scene::AlphaMode::mask;
    scene.materials[0].alpha_cutoff = 0.5F;
    scene.materials[0].opacity_texture = scene.materials[0].base_color_texture;
    scene.materials[0].opacity_texture.channel = 3;
    const std::uint32_t behind = add(scene, wall(-1.0F, 1.0F), white());
    const Rendered picture =
        render(scene, orthographic(view_down_z(0.0, 0.0, 1.0)), request(64, 64, "preview"));
    EXPECT_EQ(picture.film.layers->object[32 * 64 + 20], 1U);
    EXPECT_EQ(picture.film.layers->object[32 * 64 + 44], behind);
    EXPECT_EQ(picture.film.layers->ray_length[32 * 64 + 44], 2.0F);
}

TEST(Texture, CoordinatesThatAreNoNumbersAreHarmless) {
    scene::Scene scene = textured_wall(encode_png(64, 64, 3, checker));
    for (const float bad : {std::nanf(""), HUGE_VALF, 1e30F}) {
        for (Imath::V2f& point : scene.meshes[0].edit().texture_coordinates[0]) {
            point = Imath::V2f(bad, -bad) * (point.x - 0.5F);
        }
        const Rendered picture =
            render(scene, pinhole(view_down_z(0.0, 0.0, 1.0)), request(8, 8, "direct"));
        EXPECT_EQ(picture.summary.repaired, 0U);
    }
}

TEST(Texture, WithoutItsTextureAMaterialHasItsFactors) {
    scene::Scene scene = textured_wall({1, 2, 3, 4});
    scene.textures[0].name = "broken.png";
    scene.materials[0].base_color = Color3f(0.25F);
    scene.materials[0].emission_texture = scene.materials[0].base_color_texture;
    const Result<Renderer> renderer = Renderer::make(std::make_shared<scene::Scene>(scene));
    ASSERT_TRUE(renderer);
    ASSERT_EQ(renderer.diagnostics.size(), 1U);
    EXPECT_NE(renderer.diagnostics[0].message.find("broken.png"), std::string::npos);
    const Request asked = request(4, 4, "preview");
    Film film = *make_film(asked.layout);
    const Result<Summary> summary =
        render::render(*renderer, orthographic(view_down_z(0.0, 0.0, 1.0)), asked, film);
    ASSERT_TRUE(summary);
    EXPECT_TRUE(summary.diagnostics.empty());
    EXPECT_EQ(film.pixel(1, 1).r, 0.25F);
}

// A file that changes after the renderer was made tells when it is decoded.
TEST(Texture, IsDecodedAtOnceOrOnDemand) {
    const files::TemporaryFolder folder;
    const auto write = [&](std::uint8_t grey) {
        const auto png = encode_png(8, 8, 3, [grey](int, int) { return Pixel(3, grey); });
        folder.write("texture.png", {reinterpret_cast<const char*>(png.data()), png.size()});
    };
    scene::Scene scene = textured_wall({});
    scene.textures[0].file = folder / "texture.png";
    const Request asked = request(4, 4, "preview");
    for (const bool on_demand : {false, true}) {
        write(0);
        const auto shared = std::make_shared<const scene::Scene>(scene);
        const auto renderer = Renderer::make(shared, {.textures_on_demand = on_demand});
        ASSERT_TRUE(renderer);
        const auto moved = renderer->moved(shared, {0.0, 0.0});
        ASSERT_TRUE(moved);
        write(255);
        Film film = *make_film(asked.layout);
        ASSERT_TRUE(render::render(*moved, orthographic(view_down_z(0.0, 0.0, 1.0)), asked, film));
        EXPECT_EQ(film.pixel(1, 1).r, on_demand ? 1.0F : 0.0F);
    }
}

// The header is whole, the pixels are not.
TEST(Texture, PixelsThatCannotBeReadAreAWarningOnce) {
    constexpr int side = 256;
    const files::TemporaryFolder folder;
    const std::string file = (folder / "texture.exr").string();
    const auto output = OIIO::ImageOutput::create(file);
    ASSERT_TRUE(output->open(file, OIIO::ImageSpec(side, side, 3, OIIO::TypeDesc::HALF)));
    std::vector<float> values(std::size_t{3} * side * side);
    std::iota(values.begin(), values.end(), 0.0F);
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close());
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    scene::Scene scene = textured_wall({});
    scene.textures[0].file = file;
    const Result<Renderer> renderer = Renderer::make(std::make_shared<scene::Scene>(scene));
    ASSERT_TRUE(renderer);
    EXPECT_TRUE(renderer.diagnostics.empty());
    const camera::Camera camera = orthographic(view_down_z(0.0, 0.0, 1.0));
    const Request asked = request(256, 256, "preview");
    Film film = *make_film(asked.layout);
    const Result<Summary> first = render::render(*renderer, camera, asked, film);
    ASSERT_TRUE(first);
    ASSERT_EQ(first.diagnostics.size(), 1U);
    EXPECT_FALSE(has_errors(first.diagnostics));
    EXPECT_NE(first.diagnostics[0].message.find("cannot be read: "), std::string::npos);
    film = *make_film(asked.layout);
    EXPECT_TRUE(render::render(*renderer, camera, asked, film).diagnostics.empty());
}

}  // namespace
}  // namespace balcony::render::test::texture_test
