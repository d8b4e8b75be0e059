// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// PNG and JPEG files, which are read without OpenImageIO: each kind has the values that it reads.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <png.h>
#include <sys/stat.h>
#include <turbojpeg.h>

#include "../files/temporary_folder.hpp"
#include "balcony/images.hpp"

namespace balcony::images::testing::direct_formats_test {

namespace {

constexpr std::size_t width = 45;
constexpr std::size_t height = 21;

std::vector<std::uint8_t> noise(std::size_t count) {
    std::mt19937 random(5);
    std::vector<std::uint8_t> values(count);
    for (std::uint8_t& value : values) {
        value = static_cast<std::uint8_t>(random());
    }
    return values;
}

// TIFF's header, a directory with the orientation, and none after it.
std::string exif(int orientation, bool is_big) {
    using namespace std::string_literals;
    const auto number = static_cast<char>(orientation);
    return is_big ? "MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0"s + number + "\0\0\0\0\0\0"s
                  : "II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0"s + number + "\0\0\0\0\0\0\0"s;
}

struct PngKind {
    int color;
    int bits;
    bool has_transparent_color = false;
    int interlace = PNG_INTERLACE_NONE;
    int orientation = 0;
};

std::string png(const PngKind& kind) {
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &bytes,
        [](png_structp to, png_bytep data, std::size_t size) {
            static_cast<std::string*>(png_get_io_ptr(to))
                ->append(reinterpret_cast<const char*>(data), size);
        },
        nullptr);
    png_set_IHDR(png, info, width, height, kind.bits, kind.color, kind.interlace,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    std::vector<png_color> palette;
    for (std::size_t i = 0; i < std::size_t{1} << static_cast<unsigned>(kind.bits % 16); ++i) {
        const auto value = static_cast<png_byte>(i);
        palette.push_back({static_cast<png_byte>(7 * value), value, static_cast<png_byte>(~value)});
    }
    const std::array<png_byte, 3> alphas{0, 100, 200};
    const png_color_16 transparent{1, 1, 1, 1, 1};
    if (kind.color == PNG_COLOR_TYPE_PALETTE) {
        png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    }
    if (kind.has_transparent_color) {
        png_set_tRNS(png, info, alphas.data(), static_cast<int>(alphas.size()), &transparent);
    }
    if (kind.orientation > 0) {
        std::string data = exif(kind.orientation, true);
        png_set_eXIf_1(png, info, static_cast<png_uint_32>(data.size()),
                       reinterpret_cast<png_bytep>(data.data()));
    }
    png_write_info(png, info);
    const std::size_t row = png_get_rowbytes(png, info);
    std::vector<std::uint8_t> values = noise(row * height);
    const int passes = png_set_interlace_handling(png);
    for (int pass = 0; pass < passes; ++pass) {
        for (std::size_t y = 0; y < height; ++y) {
            png_write_row(png, values.data() + y * row);
        }
    }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

std::string jpeg(TJPF format, TJSAMP sampling, int flags = 0) {
    const std::vector<std::uint8_t> values =
        noise(width * height * static_cast<std::size_t>(tjPixelSize[format]));
    const std::unique_ptr<void, int (*)(tjhandle)> encoder(tjInitCompress(), tjDestroy);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    EXPECT_EQ(tjCompress2(encoder.get(), values.data(), width, 0, height, format, &bytes, &size,
                          sampling, 80, flags),
              0);
    const std::unique_ptr<unsigned char, void (*)(unsigned char*)> freed(bytes, tjFree);
    return {bytes, bytes + size};
}

// With EXIF data after the first marker.
std::string turned(std::string jpeg, int orientation) {
    using namespace std::string_literals;
    const std::string data = "Exif\0\0"s + exif(orientation, false);
    return jpeg.insert(2, "\xff\xe1\0"s + static_cast<char>(data.size() + 2) + data);
}

class DirectFormats : public ::testing::Test {
protected:
    // What OpenImageIO reads of a file.
    struct Reference {
        OIIO::ImageSpec spec;
        std::vector<float> floats;
        std::vector<std::uint8_t> bytes;
    };
    [[nodiscard]] Reference reference(const std::filesystem::path& file) const {
        OIIO::ImageSpec config;
        config.attribute("oiio:UnassociatedAlpha", 1);
        const auto input = OIIO::ImageInput::open(file.string(), &config);
        Reference read;
        if (!input) {
            ADD_FAILURE() << OIIO::geterror();
            return read;
        }
        read.spec = input->spec();
        const std::size_t count = width * height * static_cast<std::size_t>(read.spec.nchannels);
        read.floats.resize(count);
        read.bytes.resize(count);
        const int channels = read.spec.nchannels;
        EXPECT_TRUE(
            input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, read.floats.data()));
        EXPECT_TRUE(input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, read.bytes.data()));
        return read;
    }

    void expect_as_openimageio(const std::string& name, const std::string& content) {
        const std::filesystem::path file = folder.write(name, content);
        const Reference wanted = reference(file);
        const auto opened = ImageFile::open(file);
        ASSERT_TRUE(opened) << name << ": " << opened.diagnostics.front().message;
        ImageFile& image = **opened;
        ASSERT_EQ(image.width(), width) << name;
        ASSERT_EQ(image.height(), height) << name;
        EXPECT_EQ(image.channels(), static_cast<std::size_t>(wanted.spec.nchannels)) << name;
        EXPECT_EQ(image.channel_names(), wanted.spec.channelnames) << name;
        EXPECT_EQ(image.has_bytes(), wanted.spec.format == OIIO::TypeDesc::UINT8) << name;
        EXPECT_FALSE(image.is_float());
        EXPECT_TRUE(image.is_whole_picture());
        EXPECT_EQ(image.unassociated_alpha().has_value(), wanted.spec.alpha_channel >= 0) << name;
        if (image.unassociated_alpha()) {
            EXPECT_EQ(*image.unassociated_alpha(),
                      static_cast<std::size_t>(wanted.spec.alpha_channel));
        }
        std::vector<float> floats(wanted.floats.size());
        EXPECT_FALSE(image.read_rows(0, height, floats));
        EXPECT_EQ(floats, wanted.floats) << name;
        std::vector<std::uint8_t> bytes(wanted.bytes.size());
        EXPECT_FALSE(image.read_rows(0, height, bytes));
        EXPECT_EQ(bytes, wanted.bytes) << name;
    }

    const files::TemporaryFolder folder;
};

}  // namespace

TEST_F(DirectFormats, EachKindOfPngHasTheValuesOfOpenImageIo) {
    for (const int interlace : {PNG_INTERLACE_NONE, PNG_INTERLACE_ADAM7}) {
        for (const bool has_transparent_color : {false, true}) {
            for (const auto& [color, depths] :
                 std::initializer_list<std::pair<int, std::vector<int>>>{
                     {PNG_COLOR_TYPE_GRAY, {1, 2, 4, 8, 16}},
                     {PNG_COLOR_TYPE_PALETTE, {1, 2, 4, 8}},
                     {PNG_COLOR_TYPE_RGB, {8, 16}},
                     {PNG_COLOR_TYPE_GRAY_ALPHA, {8, 16}},
                     {PNG_COLOR_TYPE_RGB_ALPHA, {8, 16}}}) {
                const bool has_alpha = (color & PNG_COLOR_MASK_ALPHA) != 0;
                for (const int bits : depths) {
                    // One bit has no index of the third alpha.
                    const bool fits = !has_alpha && !(color == PNG_COLOR_TYPE_PALETTE && bits == 1);
                    if (has_transparent_color && !fits) {
                        continue;
                    }
                    expect_as_openimageio(std::to_string(color) + "-" + std::to_string(bits) + "-" +
                                              std::to_string(interlace) +
                                              (has_transparent_color ? "-t.png" : ".png"),
                                          png({color, bits, has_transparent_color, interlace}));
                }
            }
        }
    }
}

TEST_F(DirectFormats, EachKindOfJpegHasTheValuesOfOpenImageIo) {
    for (const TJSAMP sampling : {TJSAMP_444, TJSAMP_422, TJSAMP_420, TJSAMP_440, TJSAMP_411}) {
        expect_as_openimageio("rgb.jpg", jpeg(TJPF_RGB, sampling));
        expect_as_openimageio("cmyk.jpg", jpeg(TJPF_CMYK, sampling));
    }
    expect_as_openimageio("grey.jpg", jpeg(TJPF_GRAY, TJSAMP_GRAY));
    expect_as_openimageio("progressive.jpg", jpeg(TJPF_RGB, TJSAMP_420, TJFLAG_PROGRESSIVE));
}

TEST_F(DirectFormats, ExifDataSayHowAnImageIsSeen) {
    const std::string plain = jpeg(TJPF_RGB, TJSAMP_444);
    const std::string rgb = png({PNG_COLOR_TYPE_RGB, 8});
    for (int orientation = 1; orientation <= 8; ++orientation) {
        for (const std::string& bytes :
             {turned(plain, orientation), png({PNG_COLOR_TYPE_RGB, 8, false, 0, orientation})}) {
            const std::filesystem::path file = folder.write("turned", bytes);
            const auto seen = ImageFile::open(file);
            const auto stored = ImageFile::open(file);
            ASSERT_TRUE(seen && stored);
            (*seen)->turn_upright();
            const bool is_transposed = orientation >= 5;
            ASSERT_EQ((*seen)->width(), is_transposed ? height : width) << orientation;
            std::vector<std::uint8_t> rows(width * height * 3);
            std::vector<std::uint8_t> upright(rows.size());
            ASSERT_FALSE((*stored)->read_rows(0, (*stored)->height(), rows));
            ASSERT_FALSE((*seen)->read_rows(0, (*seen)->height(), upright));
            // The first row of the file is seen at the top, the bottom, the left or the right, and
            // its first pixel in that corner.
            const bool at_right =
                orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
            const bool at_bottom =
                orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
            const std::size_t x = at_right ? (*seen)->width() - 1 : 0;
            const std::size_t y = at_bottom ? (*seen)->height() - 1 : 0;
            EXPECT_TRUE(std::equal(
                rows.begin(), rows.begin() + 3,
                upright.begin() + static_cast<std::ptrdiff_t>(3 * (y * (*seen)->width() + x))))
                << orientation;
        }
    }
}

TEST_F(DirectFormats, DamagedExifDataAreNone) {
    const std::string plain = jpeg(TJPF_RGB, TJSAMP_444);
    const std::string whole = turned(plain, 6);
    const auto width_of = [](const std::string& bytes) {
        const auto opened = ImageFile::open(
            "a.jpg", std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
        if (!opened) {
            return std::size_t{0};
        }
        (*opened)->turn_upright();
        return (*opened)->width();
    };
    EXPECT_EQ(width_of(whole), height);
    constexpr std::size_t directory_at = 2 + 4 + 6 + 4;
    for (const auto& [at, byte] : std::initializer_list<std::pair<std::size_t, char>>{
             {directory_at - 4, 'X'}, {directory_at, '\x70'}, {directory_at + 3, '\x7f'}}) {
        std::string changed = whole;
        changed[at] = byte;
        EXPECT_EQ(width_of(changed), width) << at;
    }
}

// A segment that ends within the name of its data, and what follows looks like the rest.
TEST_F(DirectFormats, AShortSegmentHasNoExifData) {
    using namespace std::string_literals;
    std::string bytes = jpeg(TJPF_RGB, TJSAMP_444);
    bytes.insert(2, "\xff\xe1\0\x04"s + "Exif\0\0"s);
    const auto opened = ImageFile::open(
        "a.jpg", std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.diagnostics.front().message, "its header is corrupt");
}

// A marker without a length: one who takes what follows for its length sees a frame of 2 x 2 pixels
// in a comment.
TEST_F(DirectFormats, AnAmbiguousJpegHeaderIsRefused) {
    using namespace std::string_literals;
    std::string bytes = jpeg(TJPF_GRAY, TJSAMP_GRAY);
    const std::string first = "\xff\xfe\x03\xe8"s + std::string(998, 'a');
    std::string second = "\xff\xfe\xfd\xe8"s + std::string(64998, 'b');
    constexpr std::size_t misread = 2 + 2 + 0xfffe;
    second.replace(misread - 4 - first.size(), 13, "\xff\xc0\0\x0b\x08\0\x02\0\x02\x01\x01\x11\0"s);
    bytes.insert(2, "\xff\x01"s + first + second);
    const auto opened = ImageFile::open(
        "a.jpg", std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
    ASSERT_TRUE(opened);
    ASSERT_EQ((*opened)->width(), 2U);
    std::vector<std::uint8_t> rows(4);
    const auto failure = (*opened)->read_rows(0, 2, rows);
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->message, "its content is corrupt: its header is ambiguous");
}

TEST_F(DirectFormats, AHugeFileIsNotReadIntoMemory) {
    const std::filesystem::path file = folder.write("huge.png", png({PNG_COLOR_TYPE_RGB, 8}));
    std::filesystem::resize_file(file, std::uintmax_t{1} << 40U);
    const auto opened = ImageFile::open(file);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.diagnostics.front().message, "it has 1048576 MiB, more than 1024");
}

// Opening a pipe would wait for somebody who writes into it.
TEST_F(DirectFormats, NothingButFilesIsLookedInto) {
    const std::filesystem::path pipe = folder / "pipe.png";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_TRUE(require_reader(pipe).empty());
    EXPECT_FALSE(ImageFile::open(pipe));
    EXPECT_TRUE(require_reader(folder.write("a.png", png({PNG_COLOR_TYPE_RGB, 8}))).empty());
}

// What Image::encode() writes, this reads.
TEST_F(DirectFormats, WhatIsEncodedIsRead) {
    const std::vector<std::uint8_t> bytes = noise(width * height * 4);
    std::vector<std::uint16_t> words(width * height * 4);
    std::transform(bytes.begin(), bytes.end(), words.begin(),
                   [](std::uint8_t byte) { return static_cast<std::uint16_t>(byte * 257 / 3); });
    for (const Samples& samples : {Samples(std::span<const std::uint8_t>(bytes)),
                                   Samples(std::span<const std::uint16_t>(words))}) {
        const auto encoded = encode({width, height, 4, samples}, "png");
        ASSERT_TRUE(encoded);
        const auto opened = ImageFile::open("a.png", *encoded);
        ASSERT_TRUE(opened);
        std::vector<float> floats(bytes.size());
        ASSERT_FALSE((*opened)->read_rows(0, height, floats));
        for (std::size_t i = 0; i < floats.size(); ++i) {
            const float wanted = std::visit(
                [i](auto values) {
                    using Sample = typename decltype(values)::value_type;
                    return static_cast<float>(values[i]) /
                           static_cast<float>(std::numeric_limits<Sample>::max());
                },
                samples);
            ASSERT_NEAR(floats[i], wanted, 1e-7F);
        }
    }
    const auto kind = [&](std::size_t channels, const Samples& samples) {
        return kind_of_errors(encode({width, height, channels, samples}, "jpeg").diagnostics);
    };
    EXPECT_EQ(kind(4, std::span<const std::uint8_t>(bytes)), Kind::internal);
    EXPECT_EQ(kind(4, std::span<const std::uint16_t>(words)), Kind::internal);
}

// After a row that cannot be read, those before it still can.
TEST_F(DirectFormats, RowsBeforeDamageAreRead) {
    std::vector<std::uint8_t> values = noise(200 * 600 * 3);
    auto encoded = encode({200, 600, 3, std::span<const std::uint8_t>(values)}, "png");
    ASSERT_TRUE(encoded);
    (*encoded)[encoded->size() * 3 / 4] ^= 1U;
    const auto opened = ImageFile::open("a.png", *encoded);
    ASSERT_TRUE(opened);
    std::vector<std::uint8_t> rows(values.size());
    for (int time = 0; time < 2; ++time) {
        const auto failure = (*opened)->read_rows(0, 600, rows);
        ASSERT_TRUE(failure);
        EXPECT_TRUE(failure->message.starts_with("its content is corrupt: ")) << failure->message;
        ASSERT_FALSE((*opened)->read_rows(0, 100, std::span(rows).first(200 * 100 * 3)));
        EXPECT_TRUE(std::equal(rows.begin(), rows.begin() + 200 * 100 * 3, values.begin()));
    }
}

TEST_F(DirectFormats, ACutJpegIsRecognised) {
    const std::string whole = turned(jpeg(TJPF_RGB, TJSAMP_420), 1);
    for (std::size_t size = 3; size < whole.size(); ++size) {
        const auto opened = ImageFile::open(
            "a.jpg", std::span(reinterpret_cast<const std::uint8_t*>(whole.data()), size));
        ASSERT_FALSE(opened) << size;
        const std::string& message = opened.diagnostics.front().message;
        EXPECT_TRUE(message == "it is truncated or corrupt" || message == "its header is corrupt" ||
                    message == "it has no pixels")
            << size << ": " << message;
    }
}

// A file that says a thousand times that what it shows gets finer would take hours.
TEST_F(DirectFormats, AJpegOfManyScansIsRefused) {
    const std::string whole = jpeg(TJPF_GRAY, TJSAMP_GRAY, TJFLAG_PROGRESSIVE);
    const std::size_t scan = whole.rfind("\xff\xda");
    std::string bytes = whole.substr(0, scan);
    for (int i = 0; i < 600; ++i) {
        bytes += whole.substr(scan, whole.size() - 2 - scan);
    }
    bytes += "\xff\xd9";
    const auto opened = ImageFile::open(
        "a.jpg", std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
    ASSERT_TRUE(opened);
    std::vector<std::uint8_t> rows(width * height);
    EXPECT_TRUE((*opened)->read_rows(0, height, rows));
}

}  // namespace balcony::images::testing::direct_formats_test
