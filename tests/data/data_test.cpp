// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Tables, grey images and meshes: what is read, and what is said of what cannot be.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

#include <OpenImageIO/imageio.h>

#include "../files/temporary_folder.hpp"
#include "balcony/data.hpp"

namespace balcony::data::data_test {
namespace {

namespace fs = std::filesystem;

class Data : public testing::Test {
protected:
    [[nodiscard]] File write(const std::string& name, const std::string& text) const {
        return {name, folder_.write(name, text), std::nullopt};
    }

    /// The numbers of a table row by row, with | between rows; what is said if there is an error.
    [[nodiscard]] std::string table(const std::string& text) const {
        const Result<NumberTable> read = read_table(write("table.csv", text));
        if (!read) {
            return to_text(read.diagnostics);
        }
        std::string shown;
        for (const auto& row : read->rows) {
            shown += shown.empty() ? "" : "|";
            for (const NumberTable::Number& number : row) {
                shown += (number.angle ? " <" : " ") + std::to_string(number.value).substr(0, 5);
            }
        }
        return shown;
    }

    /// An image that goes through a file: EXR has colours times alpha, PNG colours and alpha.
    [[nodiscard]] Result<std::shared_ptr<const camera::GreyImage>> image(
        const std::string& name, int width, int height, int channels,
        const std::vector<float>& values, int orientation = 1) const {
        const fs::path path = folder_ / name;
        const auto output = OIIO::ImageOutput::create(path.string());
        OIIO::ImageSpec spec(width, height, channels, OIIO::TypeDesc::FLOAT);
        spec.attribute("oiio:UnassociatedAlpha", name.ends_with("png") ? 1 : 0);
        spec.attribute("Orientation", orientation);
        EXPECT_TRUE(output->open(path.string(), spec));
        EXPECT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
        output->close();
        return read_grey_image({name, path, std::nullopt});
    }

    const files::TemporaryFolder folder_;
};

std::string first_message(const Diagnostics& said) {
    return said.empty() ? "" : said.front().message;
}

// ------------------------------------------------------------------------------------- files

TEST_F(Data, AFileIsLookedForInTheFolderFirst) {
    (void)write("vase.obj", "");
    EXPECT_EQ(find_file("vase.obj", folder_.path())->path, folder_ / "vase.obj");
    EXPECT_FALSE(find_file("vase.obj", folder_.path())->bytes);
    EXPECT_TRUE(find_file("vase.obj", std::nullopt)->bytes);
    EXPECT_TRUE(find_file("vase.obj", folder_ / "nowhere")->bytes);
}

TEST_F(Data, AMissingFileGetsThePathAndTheNearestName) {
    (void)write("seeds.csv", "");
    const auto missing = find_file("seed.csv", folder_.path());
    ASSERT_FALSE(missing);
    EXPECT_EQ(first_message(missing.diagnostics), "there is no file and no built-in file named '" +
                                                      (folder_ / "seed.csv").string() + "'");
    EXPECT_EQ(missing.diagnostics[0].remedy, "did you mean 'seeds.csv'?");
    EXPECT_EQ(find_file("vsae.obj", folder_.path()).diagnostics[0].remedy,
              "did you mean 'vase.obj'?");
    EXPECT_EQ(first_message(find_file("vsae.obj", std::nullopt).diagnostics),
              "there is no built-in file named 'vsae.obj'");
}

TEST_F(Data, AMissingEndingIsFound) {
    (void)write("corners.csv", "");
    EXPECT_EQ(find_file("corners", folder_.path()).diagnostics.front().remedy,
              "did you mean 'corners.csv'?");
}

TEST_F(Data, AMissingFileIsAnError) {
    EXPECT_EQ(first_message(find_file("", folder_.path()).diagnostics), "this file name is empty");
    EXPECT_TRUE(first_message(find_file(".", folder_.path()).diagnostics)
                    .ends_with("' is a folder, not a file"));
    EXPECT_EQ(first_message(find_file("/dev/zero", folder_.path()).diagnostics),
              "'/dev/zero' is a pipe or a device, not a file");
}

// ------------------------------------------------------------------------------------- tables

TEST_F(Data, ATableHasNumbersInRows) {
    EXPECT_EQ(table("1,2\n3,4\n"), " 1.000 2.000| 3.000 4.000");
    EXPECT_EQ(table("1;2\r\n3;-.5"), " 1.000 2.000| 3.000 -0.50");
    EXPECT_EQ(table("+1\t2e1\n\n  3 \t 4\n"), " 1.000 20.00| 3.000 4.000");
    EXPECT_EQ(table("1 2  3"), " 1.000 2.000 3.000");
    EXPECT_EQ(table("\xef\xbb\xbf"
                    "1"),
              " 1.000");
}

TEST_F(Data, ATableMayHaveAHeaderAndComments) {
    EXPECT_EQ(table("# seeds\nx, y\n1, 2 # the first\n\n# the end"), " 1.000 2.000");
    EXPECT_EQ(table("\"x\";\"y\"\n1;2"), " 1.000 2.000");
}

// As spreadsheets and statistics programs write them.
TEST_F(Data, ATableMayHaveQuotesEmptyRowsAndAnyLineEnds) {
    EXPECT_EQ(table("\"x\",\"y\"\n\"1\",\" 2\"\n"), " 1.000 2.000");
    EXPECT_EQ(table("\xef\xbb\xbfx;y\r\n1;2\r\n;\r\n\r\n3;4\r\n;;;\r\n"),
              " 1.000 2.000| 3.000 4.000");
    EXPECT_EQ(table("1 2\r3 4\r"), " 1.000 2.000| 3.000 4.000");
    EXPECT_NE(table("1,,2\n").find("there is no number between these separators"),
              std::string::npos);
}

TEST_F(Data, ATableThatIsNoTextIsOneError) {
    using namespace std::string_literals;
    EXPECT_EQ(table("1,2\0"s),
              "error: 'table.csv' is not a text file: its byte 4 is zero\n"
              "  help: export the table as CSV, plain text in UTF-8\n");
}

TEST_F(Data, OnlyAFirstLineOfWordsIsAHeader) {
    EXPECT_EQ(table("-1, -2\n3, 4"), " -1.00 -2.00| 3.000 4.000");
    EXPECT_EQ(table("+1, +2"), " 1.000 2.000");
    EXPECT_EQ(table(".5, .5"), " 0.500 0.500");
    EXPECT_NE(table("1, 2\nx, y\n").find("2:1: error: this is not a number"), std::string::npos);
    EXPECT_NE(table("x, y\nu, v\n").find("2:1: error: this is not a number"), std::string::npos);
}

TEST_F(Data, AnglesHaveUnits) { EXPECT_EQ(table("180deg, 0.5rad, 1"), " <3.141 <0.500 1.000"); }

TEST_F(Data, AnInvalidNumberIsReportedWithItsPosition) {
    EXPECT_EQ(
        table("x,y\n1,2\n3,four\n"),
        "table.csv:3:3: error: this is not a number\n"
        "    3 | 3,four\n"
        "      |   ^~~~\n"
        "  help: a table contains numbers such as -0.5, 2e-3 or 30deg; '#' starts a comment\n");
    EXPECT_EQ(table("1,,2"),
              "table.csv:1:3: error: there is no number between these separators\n"
              "    1 | 1,,2\n"
              "      |   ^\n"
              "  help: write one, or remove a separator\n");
    EXPECT_EQ(table("0,5;1,5"),
              "table.csv:1:4: error: this line has two kinds of separators\n"
              "    1 | 0,5;1,5\n"
              "      |    ^\n"
              "  help: write numbers with a decimal point, 0.5, and separate them by commas\n");
    for (const char* wrong : {"1,nan", "1,inf", "1,1e999", "1,2x", "1,0x1", "1,--2", "1,2deg3"}) {
        EXPECT_NE(table(wrong).find("1:3: error: this is not a number"), std::string::npos)
            << wrong;
    }
}

TEST_F(Data, ATableWithoutNumbersIsAnError) {
    for (const char* empty : {"", "# nothing\n\n", "x,y\n"}) {
        EXPECT_NE(table(empty).find("'table.csv' has no numbers"), std::string::npos) << empty;
    }
}

TEST_F(Data, TablesAreBounded) {
    std::string many;
    for (std::size_t i = 0; i < max_numbers; ++i) {
        many += "1\n";
    }
    EXPECT_TRUE(read_table(write("many.csv", many)));
    EXPECT_EQ(first_message(read_table(write("many.csv", many + "1\n")).diagnostics),
              "this table has more than 262144 numbers");
    const File large = write("large.csv", "");
    fs::resize_file(large.path, max_table + 1);
    EXPECT_EQ(first_message(read_table(large).diagnostics), "'large.csv' is larger than 16 MB");
    std::string rubbish;
    for (int i = 0; i < 5000; ++i) {
        rubbish += "1,rubbish\n";
    }
    EXPECT_EQ(read_table(write("rubbish.csv", rubbish)).diagnostics.size(), 10U);
}

// ------------------------------------------------------------------------------------- images

TEST_F(Data, GreyIsTheLumaOfColors) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto grey = image("grey.exr", 4, 1, 1, {0.25F, 2.0F, -1.0F, nan});
    ASSERT_TRUE(grey) << to_text(grey.diagnostics);
    EXPECT_EQ((*grey)->values, (std::vector<float>{0.25F, 1.0F, 0.0F, 0.0F}));
    const auto colors = image("colors.exr", 1, 3, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1});
    ASSERT_TRUE(colors);
    EXPECT_EQ((*colors)->height, 3U);
    EXPECT_EQ((*colors)->values, (std::vector<float>{0.2126F, 0.7152F, 0.0722F}));
}

TEST_F(Data, AnImageIsUpright) {
    // What is seen at the left is the first row of the file.
    const auto turned = image("turned.tif", 1, 2, 1, {0.25F, 0.75F}, 8);
    ASSERT_TRUE(turned) << to_text(turned.diagnostics);
    EXPECT_EQ((*turned)->width, 2U);
    EXPECT_EQ((*turned)->values, (std::vector<float>{0.25F, 0.75F}));
}

TEST_F(Data, AlphaCountsOnce) {
    const std::vector<float> values{0.6F, 0.6F, 0.6F, 0.2F, 1, 1, 1, 0};
    const auto apart = image("apart.png", 2, 1, 4, values);
    ASSERT_TRUE(apart) << to_text(apart.diagnostics);
    EXPECT_NEAR((*apart)->values[0], 0.6F * 0.2F, 1e-6F);  // Both are whole in 8 bits.
    EXPECT_EQ((*apart)->values[1], 0.0F);
    const auto multiplied = image("multiplied.exr", 2, 1, 4, values);
    ASSERT_TRUE(multiplied);
    EXPECT_FLOAT_EQ((*multiplied)->values[0], 0.6F);
}

TEST_F(Data, AnInvalidImageIsAnError) {
    const auto text = read_grey_image(write("text.png", "no image at all"));
    ASSERT_FALSE(text);
    EXPECT_TRUE(
        first_message(text.diagnostics).starts_with("'text.png' cannot be read as an image: "))
        << first_message(text.diagnostics);
    EXPECT_EQ(first_message(read_grey_image(write("unknown.xyz", "")).diagnostics),
              "'unknown.xyz' cannot be read as an image: its format is not supported");
    EXPECT_EQ(first_message(read_grey_image(write("cut.png", "\x89PNG\r\n\x1a\n")).diagnostics),
              "'cut.png' cannot be read as an image: its header is corrupt");
}

TEST_F(Data, AnImageTooLargeIsRefusedByItsHeader) {
    // The Radiance format has its size in text; the pixels are not there.
    const auto large = read_grey_image(
        write("large.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1025 +X 16384\n"));
    ASSERT_FALSE(large);
    EXPECT_EQ(first_message(large.diagnostics),
              "'large.hdr' has 16384 x 1025 pixels, more than 16 million");
}

// ------------------------------------------------------------------------------------- meshes

const std::string square = R"(
v 0 0 0
v 1 0 0
v 1 2 0
v 0 2 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
vn 0 0 1
)";

TEST_F(Data, AMeshIsTurnedUpright) {
    const auto mesh = read_mesh(write("square.obj", square + "f 1/1/1 2/2/1 3/3/1 4/4/1\n"));
    ASSERT_TRUE(mesh) << to_text(mesh.diagnostics);
    EXPECT_TRUE(mesh.diagnostics.empty()) << to_text(mesh.diagnostics);
    ASSERT_EQ((*mesh)->triangles.size(), 2U);
    for (const auto& triangle : (*mesh)->triangles) {
        for (const auto& corner : triangle) {
            // y is up in the file: (x, y, z) is (x, -z, y); v runs upwards.
            EXPECT_EQ(corner.position[0], corner.uv[0]);
            EXPECT_EQ(corner.position[1], 0.0);
            EXPECT_EQ(corner.position[2], 2.0 * corner.uv[1]);
            EXPECT_EQ(corner.normal, (std::array<double, 3>{0.0, -1.0, 0.0}));
        }
    }
}

TEST_F(Data, DegenerateTrianglesAreSkipped) {
    const auto mesh = read_mesh(write("mixed.obj", square + "f 1/1/1 2/2/1 3/3/1\n"
                                                            "f 1/1/1 2/1/1 3/1/1\n"
                                                            "f 1/1/1 2/2/1 1/4/1\n"
                                                            "o bare\nf 1//1 2//1 3//1\n"));
    ASSERT_TRUE(mesh) << to_text(mesh.diagnostics);
    EXPECT_EQ((*mesh)->triangles.size(), 1U);
    EXPECT_EQ(to_text(mesh.diagnostics),
              "warning: 1 of 3 triangles of 'mixed.obj' have no texture coordinates and are "
              "skipped\n"
              "warning: 1 of 3 triangles of 'mixed.obj' have no area in texture coordinates and "
              "are skipped\n");
}

// Three corners on a slanting line of the texture.
TEST_F(Data, AnAreaInTextureIsNoLine) {
    const auto mesh = read_mesh(write("line.obj", square + "vt 0.5 0.5\n"
                                                           "f 1/1/1 2/2/1 3/3/1\n"
                                                           "f 1/1/1 2/5/1 3/3/1\n"));
    ASSERT_TRUE(mesh) << to_text(mesh.diagnostics);
    EXPECT_EQ((*mesh)->triangles.size(), 1U);
}

// A triangle across z whose normals lean towards x, with x turned round and twice as long: normals
// go by the inverse transpose, and corners still run counter-clockwise about them.
TEST_F(Data, AMirroredInstanceFacesTheSameSide) {
    const std::string gltf =
        R"({"asset": {"version": "2.0"}, "scene": 0,
        "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "scale": [-2, 1, 1]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
             "min": [0, 0, 0], "max": [1, 1, 0]},
            {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC2"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36},
                        {"buffer": 0, "byteOffset": 36, "byteLength": 36},
                        {"buffer": 0, "byteOffset": 72, "byteLength": 24}],
        "buffers": [{"byteLength": 96, "uri": "data:application/octet-stream;base64,)"
        "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAmpkZPwAAAADNzEw/mpkZPwAAAADN"
        "zEw/mpkZPwAAAADNzEw/AAAAAAAAAAAAAIA/AAAAAAAAAAAAAIA/"
        R"("}]})";
    const auto mesh = read_mesh(write("mirrored.gltf", gltf));
    ASSERT_TRUE(mesh) << to_text(mesh.diagnostics);
    ASSERT_EQ((*mesh)->triangles.size(), 1U);
    const auto& [a, b, c] = (*mesh)->triangles[0];
    // The file's (x, y, z) is (x, -z, y): the triangle lies across y, and its normals, which were
    // (3, 0, 4), point to (-3/2, 0, 4) of the file.
    const double size = std::hypot(1.5, 4.0);
    EXPECT_NEAR(a.normal[0], -1.5 / size, 1e-6);  // Floats.
    EXPECT_NEAR(a.normal[1], -4.0 / size, 1e-6);
    EXPECT_NEAR(a.normal[2], 0.0, 1e-6);
    const auto side = [&a](const auto& to, std::size_t k) {
        return to.position[k] - a.position[k];
    };
    const double across = side(b, 2) * side(c, 0) - side(b, 0) * side(c, 2);
    EXPECT_NEAR(across, -2.0, 1e-6) << "twice the triangle's area, to the normals' side";
}

TEST_F(Data, MeshFilesAreBounded) {
    const File large = write("large.obj", "");
    fs::resize_file(large.path, max_mesh_file + 1);
    EXPECT_EQ(first_message(read_mesh(large).diagnostics), "'large.obj' is larger than 500 MB");
}

TEST_F(Data, AMeshWithoutTextureCoordinatesIsAnError) {
    const auto bare = read_mesh(write("bare.obj", square + "f 1//1 2//1 3//1\n"));
    EXPECT_EQ(first_message(bare.diagnostics),
              "'bare.obj' has no triangle with texture coordinates");
    EXPECT_FALSE(read_mesh(write("empty.obj", "")));
    EXPECT_FALSE(read_mesh(write("mesh.stl", "")));
}

// The vase is a solid of revolution: its normals point away from its axis, its texture
// coordinates are its angle and height.
TEST_F(Data, TheVaseIsBuiltIn) {
    const auto file = find_file("vase.obj", std::nullopt);
    ASSERT_TRUE(file);
    const auto mesh = read_mesh(*file);
    ASSERT_TRUE(mesh) << to_text(mesh.diagnostics);
    EXPECT_TRUE(mesh.diagnostics.empty()) << to_text(mesh.diagnostics);
    EXPECT_EQ((*mesh)->triangles.size(), 2U * 32U * 20U);
    for (const auto& triangle : (*mesh)->triangles) {
        for (const auto& corner : triangle) {
            const auto& [x, y, z] = corner.position;
            const double radius = std::hypot(x, y);
            const double angle = 2.0 * std::numbers::pi * corner.uv[0];
            // The file has five digits.
            EXPECT_NEAR(x, radius * std::cos(angle), 2e-5);
            EXPECT_NEAR(y, radius * std::sin(angle), 2e-5);
            EXPECT_NEAR(z, 2.0 * corner.uv[1], 2e-5);
            EXPECT_GT(x * corner.normal[0] + y * corner.normal[1], 0.1 * radius);
        }
    }
}

}  // namespace
}  // namespace balcony::data::data_test
