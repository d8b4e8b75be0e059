// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Maps of rays and positions: what is read, and what is said of what cannot be.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <random>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "balcony/data.hpp"

namespace balcony::data::pixel_maps_test {
namespace {

using camera::PixelMap;
using MapResult = Result<std::shared_ptr<const PixelMap>>;
using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t width = 3;
constexpr std::size_t height = 2;

/// Number k of the pixel in row i and column j.
double number(std::size_t i, std::size_t j, std::size_t k) {
    return static_cast<double>(100 * i + 10 * j + k) + 0.25;
}

struct NpyForm {
    std::string type = "<f8";
    bool fortran = false;
    std::string shape = "(2, 3, 6)";
    std::size_t columns = 6;
    char version = 1;
    double (*value)(std::size_t i, std::size_t j, std::size_t k) = number;
};

template <class Number>
void append(Bytes& bytes, Number value, bool big_endian) {
    std::array<std::uint8_t, sizeof(Number)> made{};
    std::memcpy(made.data(), &value, sizeof value);
    if (big_endian != (std::endian::native == std::endian::big)) {
        std::reverse(made.begin(), made.end());
    }
    bytes.insert(bytes.end(), made.begin(), made.end());
}

Bytes npy(const NpyForm& form) {
    const std::string header = "{'descr': '" + form.type +
                               "', 'fortran_order': " + (form.fortran ? "True" : "False") +
                               ", 'shape': " + form.shape + ", }\n";
    Bytes bytes{0x93, 'N', 'U', 'M', 'P', 'Y', static_cast<std::uint8_t>(form.version), 0};
    bytes.push_back(static_cast<std::uint8_t>(header.size()));
    bytes.insert(bytes.end(), form.version == 1 ? 1 : 3, 0);
    bytes.insert(bytes.end(), header.begin(), header.end());
    const std::size_t count = width * height * form.columns;
    for (std::size_t n = 0; n < count; ++n) {
        const std::size_t i = form.fortran ? n % height : n / (width * form.columns);
        const std::size_t j = form.fortran ? n / height % width : n / form.columns % width;
        const std::size_t k = form.fortran ? n / (height * width) : n % form.columns;
        const double value = form.value(i, j, k);
        if (form.type.ends_with('4')) {
            append(bytes, static_cast<float>(value), form.type.starts_with('>'));
        } else {
            append(bytes, value, form.type.starts_with('>'));
        }
    }
    return bytes;
}

MapResult read(const Bytes& bytes, const char* name = "rays.npy") {
    return read_ray_map(File::in_memory(name, name, bytes));
}

std::string said(const MapResult& result) {
    if (result) {
        return "nothing";
    }
    const Diagnostic& first = result.diagnostics.front();
    return first.message + "; " + first.remedy;
}

TEST(RayMapArrays, AreReadInEveryOrderOfTheirNumbers) {
    for (const char* type : {"<f8", ">f8", "<f4", ">f4"}) {
        for (const bool fortran : {false, true}) {
            for (const char version : {'\x01', '\x02', '\x03'}) {
                const MapResult map =
                    read(npy({.type = type, .fortran = fortran, .version = version}));
                ASSERT_TRUE(map) << said(map);
                ASSERT_EQ((*map)->width, width);
                ASSERT_EQ((*map)->height, height);
                for (std::size_t k = 0; k < 6; ++k) {
                    EXPECT_EQ((*map)->channels[k][5], number(1, 2, k)) << type << fortran;
                    EXPECT_EQ((*map)->channels[k][1], number(0, 1, k)) << type << fortran;
                }
            }
        }
    }
}

TEST(RayMapArrays, HaveNoRayWithoutADirectionOrWhereTheySaySo) {
    const MapResult zeros = read(npy({.value = [](std::size_t i, std::size_t j, std::size_t k) {
        return i == 1 && j == 1 ? 0.0 : number(i, j, k);
    }}));
    ASSERT_TRUE(zeros) << said(zeros);
    EXPECT_EQ((*zeros)->valid, (std::vector<std::uint8_t>{1, 1, 1, 1, 0, 1}));
    const MapResult flags = read(npy({.shape = "(2, 3, 7)",
                                      .columns = 7,
                                      .value = [](std::size_t, std::size_t j, std::size_t k) {
                                          return k < 6 ? (j == 0 ? NAN : 1.0) : (j > 0 ? 1.0 : 0.0);
                                      }}));
    ASSERT_TRUE(flags) << said(flags);
    EXPECT_EQ((*flags)->valid, (std::vector<std::uint8_t>{0, 1, 1, 0, 1, 1}));
}

TEST(RayMapArrays, ThatCannotBeReadSayWhy) {
    EXPECT_EQ(said(read(npy({.value =
                                 [](std::size_t i, std::size_t j, std::size_t k) {
                                     return i == 1 && j == 2 && k == 4 ? NAN : 1.0;
                                 }}))),
              "'rays.npy' has a number that is not finite in direction.Y of the pixel in column 3 "
              "and row 2 from the top left, where it says that there is a ray; where there is no "
              "ray, make its direction or valid.A 0");
    EXPECT_EQ(said(read(npy({.type = "<i8"}))),
              "the numbers of 'rays.npy' are not floats of 4 or 8 bytes; convert the array with "
              ".astype(\"f8\") before numpy.save");
    EXPECT_EQ(said(read(npy({.shape = "(6, 6)"}))),
              "the array in 'rays.npy' has the shape (6, 6); give it the shape (height, width, "
              "columns)");
    EXPECT_EQ(said(read(npy({.shape = "(4, 3, 3)"}))),
              "the array in 'rays.npy' has 3 numbers for each pixel, but a ray map has 6; the "
              "columns are origin.X, origin.Y, origin.Z, direction.X, direction.Y, direction.Z");
    const std::string ends = "'rays.npy' ends before its ";
    EXPECT_TRUE(said(read(npy({.shape = "(3, 3, 6)"}))).starts_with(ends));
    EXPECT_TRUE(said(read(npy({.shape = "(18446744073709551615, 9223372036854775808, 6)"})))
                    .starts_with(ends));
    EXPECT_TRUE(said(read(npy({.shape = "(0, 3, 6)"}))).starts_with(ends));
    EXPECT_EQ(said(read(npy({.version = 9}))),
              "'rays.npy' is truncated or no array of NumPy; write it again with numpy.save");
    EXPECT_EQ(said(read({'P', 'K'})), "'rays.npy' is no array of NumPy; write it with numpy.save");
    EXPECT_EQ(said(read(npy({.value = [](std::size_t, std::size_t, std::size_t) { return 0.0; }}))),
              "'rays.npy' has no ray in any pixel; check that it is the right file");
}

// -------------------------------------------------------------------------------------- EXR

struct ExrForm {
    std::vector<std::string> channels;
    bool cropped = false;
    float value = 0.5F;
};

Bytes exr(const ExrForm& form) {
    OIIO::ImageSpec spec(width, height, static_cast<int>(form.channels.size()),
                         OIIO::TypeDesc::FLOAT);
    spec.channelnames = form.channels;
    spec.full_width += form.cropped ? 1 : 0;
    std::vector<float> values(width * height * form.channels.size(), form.value);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] += static_cast<float>(i % form.channels.size());
    }
    Bytes bytes;
    OIIO::Filesystem::IOVecOutput proxy(bytes);
    const auto output = OIIO::ImageOutput::create("rays.exr");
    output->set_ioproxy(&proxy);
    EXPECT_TRUE(output->open("rays.exr", spec) &&
                output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
    output->close();
    return bytes;
}

const std::vector<std::string> ray_names{"origin.X",    "origin.Y",    "origin.Z",
                                         "direction.X", "direction.Y", "direction.Z"};

TEST(RayMapImages, AreReadByTheNamesOfTheirChannels) {
    std::vector<std::string> names = ray_names;
    std::reverse(names.begin(), names.end());
    names.insert(names.begin(), "ray_length.Z");
    const MapResult map = read(exr({names}), "rays.exr");
    ASSERT_TRUE(map) << said(map);
    EXPECT_EQ((*map)->channels[0][0], 6.5);
    EXPECT_EQ((*map)->channels[5][3], 1.5);
}

TEST(RayMapImages, ThatCannotBeReadSayWhy) {
    std::vector<std::string> names = ray_names;
    names.pop_back();
    EXPECT_TRUE(said(read(exr({names}), "rays.exr"))
                    .starts_with("'rays.exr' has no channel direction.Z, but "));
    EXPECT_TRUE(said(read(exr({ray_names, true}), "rays.exr"))
                    .starts_with("'rays.exr' has only a part of its picture; "));
    EXPECT_TRUE(
        said(read(exr({ray_names, false, std::numeric_limits<float>::infinity()}), "rays.exr"))
            .starts_with("'rays.exr' has a number that is not finite in origin.X"));
    EXPECT_TRUE(
        said(read({'x'}, "rays.exr")).starts_with("'rays.exr' cannot be read as a ray map"));
}

TEST(StMaps, AreImages) {
    const Bytes bytes = exr({{"R", "G", "B"}});
    const MapResult map = read_st_map(File::in_memory("lens.exr", "lens.exr", bytes));
    ASSERT_TRUE(map) << said(map);
    EXPECT_EQ((*map)->channels[0][0], 0.5);
    EXPECT_EQ((*map)->channels[1][4], 1.5);
    const Bytes grey = exr({{"Y"}});
    EXPECT_EQ(
        said(read_st_map(File::in_memory("grey.exr", "grey.exr", grey))),
        "'grey.exr' has no channel R, but Y; an STMap has its positions in the channels R and "
        "G");
    const Bytes masked = exr({{"R", "G", "A"}, false, -2.0F});
    EXPECT_EQ(said(read_st_map(File::in_memory("clear.exr", "clear.exr", masked))),
              "'clear.exr' has no position in any pixel; check that it is the right file");
}

// -------------------------------------------------------------------------------- any bytes

TEST(PixelMaps, OfAnyBytesAreReadOrRefused) {
    std::mt19937 random(10);
    const std::array<std::pair<Bytes, const char*>, 2> originals{
        {{npy({}), "rays.npy"}, {exr({ray_names}), "rays.exr"}}};
    for (const auto& [original, name] : originals) {
        std::size_t refused = 0;
        for (int round = 0; round < 3000; ++round) {
            Bytes bytes = original;
            for (std::size_t change = 1 + random() % 4; change > 0; --change) {
                bytes[random() % std::min<std::size_t>(bytes.size(), 400)] =
                    static_cast<std::uint8_t>(random());
            }
            if (random() % 4 == 0) {
                bytes.resize(random() % bytes.size());
            }
            const MapResult map = read(bytes, name);
            refused += map ? 0 : 1;
            EXPECT_TRUE(map || has_errors(map.diagnostics));
        }
        EXPECT_GT(refused, 100U) << name;
    }
}

}  // namespace
}  // namespace balcony::data::pixel_maps_test
