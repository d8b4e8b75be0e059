// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Textures that do not fit into memory: the image itself is read again when a look-up needs it.

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"
#include "shading/textures/texture_library.hpp"
#include "support.hpp"

namespace balcony::render::test::image_read_again_test {
namespace {

using Imath::V2f;

constexpr int side = 300;
constexpr float half_code = 0.5F / 255.0F;

void write_grey(const std::filesystem::path& file, int height, std::uint8_t code) {
    const std::vector<std::uint8_t> bytes =
        encode_png(side, height, 3, [&](int, int) { return std::vector<std::uint8_t>(3, code); });
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
}

// A texture of an image file, held in a temporary file.
class Filed {
public:
    explicit Filed(const std::filesystem::path& image) : library_(scene_of(image), 0, warnings_) {}

    // The mean of all, then a texel of the image itself.
    [[nodiscard]] float mean() const { return red({V2f(0.5F), V2f(1.0F, 0.0F), V2f(0.0F, 1.0F)}); }
    [[nodiscard]] float texel() const { return red({V2f(0.5F), V2f(0.0F), V2f(0.0F)}); }
    [[nodiscard]] Diagnostics warnings() const { return library_.warnings(); }

private:
    [[nodiscard]] static scene::Scene scene_of(const std::filesystem::path& image) {
        scene::Scene scene;
        scene::Material material = white();
        material.roughness_texture.index = add_texture(scene, {});
        scene.textures[0].name = image.filename().string();
        scene.textures[0].file = image;
        add(scene, wall(0.0F, 1.0F), material);
        return scene;
    }
    [[nodiscard]] float red(const TextureFootprint& footprint) const {
        return library_.look_up(scene::TextureIndex(0), TextureEncoding::linear, footprint).r;
    }

    Diagnostics warnings_;
    TextureLibrary library_;
};

TEST(ImageReadAgain, OnlyForLookUpsInTheImageItself) {
    const files::TemporaryFolder folder;
    const std::filesystem::path file = folder / "grey.png";
    write_grey(file, side, 100);
    const Filed filed(file);
    EXPECT_NEAR(filed.mean(), 100.0F / 255.0F, half_code);
    write_grey(file, side, 200);
    EXPECT_NEAR(filed.mean(), 100.0F / 255.0F, half_code);
    EXPECT_NEAR(filed.texel(), 200.0F / 255.0F, half_code);
    EXPECT_TRUE(filed.warnings().empty());
}

TEST(ImageReadAgain, AnImageOfAnotherSizeIsAWarning) {
    const files::TemporaryFolder folder;
    const std::filesystem::path file = folder / "grey.png";
    write_grey(file, side, 100);
    const Filed filed(file);
    EXPECT_NEAR(filed.mean(), 100.0F / 255.0F, half_code);
    write_grey(file, side + 1, 100);
    (void)filed.texel();  // The look-up that notices.
    EXPECT_EQ(filed.mean(), 1.0F);
    const Diagnostics warnings = filed.warnings();
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].message.find("'grey.png' cannot be read again: it has changed"),
              std::string::npos)
        << warnings[0].message;
}

TEST(ImageReadAgain, AnImageThatIsGoneIsAWarning) {
    const files::TemporaryFolder folder;
    const std::filesystem::path file = folder / "grey.png";
    write_grey(file, side, 100);
    const Filed filed(file);
    EXPECT_NEAR(filed.mean(), 100.0F / 255.0F, half_code);
    std::filesystem::remove(file);
    EXPECT_NEAR(filed.mean(), 100.0F / 255.0F, half_code);
    (void)filed.texel();
    EXPECT_EQ(filed.mean(), 1.0F);
    const Diagnostics warnings = filed.warnings();
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].message.find("'grey.png' cannot be read again: there is no file"),
              std::string::npos)
        << warnings[0].message;
}

}  // namespace
}  // namespace balcony::render::test::image_read_again_test
