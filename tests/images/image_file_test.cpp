// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Image files: which are opened, what is checked before pixels are read, and that rows are rows.

#include "balcony/images.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string_view>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "../files/temporary_folder.hpp"

namespace balcony::images::testing::image_file_test {

namespace {

class Images : public ::testing::Test {
protected:
    [[nodiscard]] std::filesystem::path write(const std::string& name,
                                              const std::string& bytes) const {
        return folder.write(name, bytes);
    }

    static constexpr int width = 37;
    static constexpr int height = 29;

    // Three channels of pixels that all differ, in a format by the name's ending.
    [[nodiscard]] std::filesystem::path image(const std::string& name, int tile_side = 0) const {
        std::vector<float> values;
        for (int i = 0; i < width * height; ++i) {
            values.insert(values.end(), {static_cast<float>(i % 256) / 255.0F,
                                         static_cast<float>(i / 256) / 255.0F, 0.5F});
        }
        const std::filesystem::path file = folder / name;
        const auto output = OIIO::ImageOutput::create(file.string());
        OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::UINT8);
        spec.tile_width = tile_side;
        spec.tile_height = tile_side;
        EXPECT_TRUE(output->open(file.string(), spec)) << output->geterror();
        EXPECT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
        EXPECT_TRUE(output->close());
        return file;
    }

    [[nodiscard]] static std::vector<std::uint8_t> bytes_of(const std::filesystem::path& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    }

    const files::TemporaryFolder folder;
};

constexpr const char* endings[] = {"png", "jpg", "webp", "tif", "exr", "hdr", "tga", "bmp"};

std::vector<float> rows_of(ImageFile& file, std::size_t begin, std::size_t end) {
    std::vector<float> values((end - begin) * file.width() * file.channels());
    const auto failure = file.read_rows(begin, end, values);
    EXPECT_FALSE(failure) << failure->message;
    return values;
}

std::string reason(const Result<std::unique_ptr<ImageFile>>& opened) {
    return opened ? "opened" : opened.diagnostics.front().message;
}

std::string reason(std::string_view name, std::string_view bytes) {
    return reason(ImageFile::open(
        name, std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size())));
}

std::string big_endian(std::size_t number, unsigned bytes) {
    std::string text;
    for (unsigned shift = 8 * bytes; shift > 0; shift -= 8) {
        text += static_cast<char>(number >> (shift - 8) & 0xffU);
    }
    return text;
}

std::string little_endian(std::size_t number, unsigned bytes) {
    const std::string text = big_endian(number, bytes);
    return {text.rbegin(), text.rend()};
}

std::string png(std::size_t width, std::size_t height) {
    return "\x89PNG\r\n\x1a\n" + big_endian(13, 4) + "IHDR" + big_endian(width, 4) +
           big_endian(height, 4) + std::string("\x08\x02\0\0\0crc.", 9) + std::string(4, '\0') +
           "IENDcrc.";
}

// An application's segment, then the frame.
std::string jpeg(std::size_t width, std::size_t height) {
    return "\xff\xd8\xff\xe0" + big_endian(4, 2) + "ab\xff\xc0" + big_endian(11, 2) + "\x08" +
           big_endian(height, 2) + big_endian(width, 2) + std::string("\x01\x01\x11\0", 4);
}

std::string bmp(std::size_t width, std::size_t height) {
    return "BM" + std::string(12, '\0') + little_endian(40, 4) + little_endian(width, 4) +
           little_endian(height, 4) + little_endian(1, 2) + little_endian(24, 2) +
           std::string(24, '\0');
}

std::string webp(std::size_t width, std::size_t height) {
    return "RIFF" + little_endian(22, 4) + "WEBPVP8X" + little_endian(10, 4) +
           std::string(4, '\0') + little_endian(width - 1, 3) + little_endian(height - 1, 3);
}

std::string tga(std::size_t width, std::size_t height) {
    return std::string("\0\0\x02\0\0\0\0\0\0\0\0\0", 12) + little_endian(width, 2) +
           little_endian(height, 2) + std::string("\x18\0", 2);
}

}  // namespace

TEST_F(Images, BytesAreTheFloatsTimes255) {
    for (const std::string ending : endings) {
        Result<std::unique_ptr<ImageFile>> opened = ImageFile::open(image("image." + ending));
        ASSERT_TRUE(opened) << ending;
        EXPECT_EQ((*opened)->has_bytes(), ending != "exr" && ending != "hdr") << ending;
        if (!(*opened)->has_bytes()) {
            continue;
        }
        const std::vector<float> floats = rows_of(**opened, 3, 20);
        std::vector<std::uint8_t> bytes(floats.size());
        EXPECT_FALSE((*opened)->read_rows(3, 20, bytes)) << ending;
        for (std::size_t i = 0; i < floats.size(); ++i) {
            ASSERT_NEAR(255.0F * floats[i], bytes[i], 1e-4F) << ending << ' ' << i;
        }
    }
}

TEST_F(Images, TheFirstBytesTellTheFormat) {
    for (const std::string ending : endings) {
        const std::filesystem::path file = image("image." + ending);
        const std::vector<std::uint8_t> bytes = bytes_of(file);
        // By the bytes alone; TGA needs its ending.
        const char* name = ending == "tga" ? "other.TGA" : "other.gif";
        for (Result<std::unique_ptr<ImageFile>>& opened :
             std::array{ImageFile::open(file), ImageFile::open(name, bytes)}) {
            ASSERT_TRUE(opened) << ending << ": " << reason(opened);
            EXPECT_EQ((*opened)->width(), static_cast<std::size_t>(width)) << ending;
            EXPECT_EQ((*opened)->height(), static_cast<std::size_t>(height)) << ending;
            EXPECT_EQ((*opened)->channels(), 3U) << ending;
            const std::vector<float> values = rows_of(**opened, 0, height);
            // Formats with a loss spread a colour to its neighbours.
            constexpr float loss = 0.1F;
            EXPECT_NEAR(values[3 * 20], 20.0F / 255.0F, loss) << ending;
            EXPECT_NEAR(values[3 * 20 + 2], 0.5F, loss) << ending;
        }
    }
}

TEST_F(Images, RowsComeInAnyOrder) {
    for (const std::string ending : endings) {
        auto opened = ImageFile::open(image("image." + ending));
        ASSERT_TRUE(opened) << ending;
        const std::vector<float> all = rows_of(**opened, 0, height);
        for (const std::size_t begin : {20U, 3U, 11U, 0U}) {
            const std::vector<float> part = rows_of(**opened, begin, begin + 5);
            EXPECT_TRUE(std::equal(part.begin(), part.end(),
                                   all.begin() + static_cast<std::ptrdiff_t>(begin) * width * 3))
                << ending << " " << begin;
        }
    }
}

TEST_F(Images, WhatCannotBeIsAnErrorOfTheCaller) {
    const auto opened = ImageFile::open(image("image.png"));
    ASSERT_TRUE(opened);
    std::vector<float> row(width * 3);
    EXPECT_FALSE((*opened)->read_rows(0, 1, row));
    const auto refused = [&](std::size_t begin, std::size_t end, std::size_t count) {
        const auto failure = (*opened)->read_rows(begin, end, std::span(row).first(count));
        return failure && failure->kind == Kind::internal;
    };
    EXPECT_TRUE(refused(0, 1, row.size() - 1));
    EXPECT_TRUE(refused(1, 0, row.size()));
    EXPECT_TRUE(refused(height, height + 1, row.size()));

    const std::vector<std::uint8_t> samples(12);
    const auto kind = [](const auto& made) { return kind_of_errors(made.diagnostics); };
    EXPECT_TRUE(encode({2, 2, 3, samples}, "png"));
    EXPECT_EQ(kind(encode({2, 2, 4, samples}, "png")), Kind::internal);
    EXPECT_EQ(kind(encode({6, 1, 2, samples}, "png")), Kind::internal);
    EXPECT_EQ(kind(encode({0, 2, 3, {}}, "png")), Kind::internal);
    EXPECT_EQ(kind(encode({2, 2, 3, samples}, "gif")), Kind::internal);

    const std::vector<float> values(16);
    EXPECT_TRUE(FilteredImage::make({2, 2, values}, false));
    EXPECT_EQ(kind(FilteredImage::make({2, 3, values}, false)), Kind::internal);
    EXPECT_EQ(kind(FilteredImage::make({0, 0, {}}, false)), Kind::internal);
}

TEST_F(Images, TiledImagesAreReadByRows) {
    auto plain = ImageFile::open(image("plain.tif"));
    auto tiled = ImageFile::open(image("tiled.tif", 16));
    ASSERT_TRUE(plain && tiled);
    for (const auto& [begin, end] : {std::pair{0U, 29U}, {5U, 7U}, {15U, 17U}, {28U, 29U}}) {
        EXPECT_EQ(rows_of(**plain, begin, end), rows_of(**tiled, begin, end)) << begin;
    }
}

// TIFF 6.0, section 8: where the first row and the first column of the file are seen.
TEST_F(Images, AnOrientationIsWhereTheFirstRowAndColumnAreSeen) {
    constexpr std::array<const char*, 8> seen{"abc/def",  "cba/fed",  "fed/cba",  "def/abc",
                                              "ad/be/cf", "da/eb/fc", "fc/eb/da", "cf/be/ad"};
    constexpr std::size_t channels = 3;
    std::vector<std::uint8_t> stored;
    for (const char letter : std::string_view("abcdef")) {
        stored.insert(stored.end(), {static_cast<std::uint8_t>(letter), 1, 2});
    }
    for (int orientation = 0; orientation <= 9; ++orientation) {
        const std::filesystem::path file = folder / "turned.tif";
        const auto output = OIIO::ImageOutput::create(file.string());
        OIIO::ImageSpec spec(3, 2, channels, OIIO::TypeDesc::UINT8);
        spec.attribute("Orientation", orientation);
        ASSERT_TRUE(output->open(file.string(), spec) &&
                    output->write_image(OIIO::TypeDesc::UINT8, stored.data()) && output->close());
        auto opened = ImageFile::open(file);
        ASSERT_TRUE(opened);
        const bool known = 1 <= orientation && orientation <= 8;
        ImageFile* const image = opened->get();
        image->turn_upright();
        std::string letters;
        std::string from_floats;
        for (std::size_t y = 0; y < image->height(); ++y) {
            std::vector<std::uint8_t> row(image->width() * channels);
            ASSERT_FALSE(image->read_rows(y, y + 1, row));
            const std::vector<float> floats = rows_of(*image, y, y + 1);
            letters += y > 0 ? "/" : "";
            from_floats += y > 0 ? "/" : "";
            for (std::size_t x = 0; x < row.size(); x += channels) {
                letters += static_cast<char>(row[x]);
                from_floats += static_cast<char>(std::lround(255.0F * floats[x]));
                EXPECT_EQ(row[x + 2], 2);
            }
        }
        EXPECT_EQ(letters, seen[known ? static_cast<std::size_t>(orientation) - 1 : 0])
            << orientation;
        EXPECT_EQ(from_floats, letters);
        std::vector<float> row(image->width() * channels);
        EXPECT_TRUE(image->read_rows(image->height(), image->height() + 1, row));
    }
}

TEST_F(Images, NoOtherFormatIsOpened) {
    const std::string unknown = "its format is not supported";
    for (const auto& [name, bytes] : std::initializer_list<std::pair<const char*, std::string>>{
             {"a.null?RES=0x0&CHANNELS=3", ""},
             {"image.pgm", "P5 4 4 255\n0123456789abcdef"},
             {"image.gif", "GIF89a\x04\0\x04\0\0\0\0"},
             {"image.tga", std::string(18, '\0')},
             {"image.tga", "no header of an image"},
             {"image.png", ""},
             {"image.webp", "RIFF"},
             {"image.png", "no image at all"}}) {
        EXPECT_EQ(reason(name, bytes), unknown) << name;
        EXPECT_EQ(reason(ImageFile::open(write(name, bytes))), unknown) << name;
    }
    EXPECT_EQ(reason(ImageFile::open(folder.path())),
              "'" + folder.path().string() + "' is a folder, not a file");
}

TEST_F(Images, TooLargeAHeaderIsRefused) {
    const std::pair<const char*, std::string> headers[] = {{"a.png", png(20000, 5001)},
                                                           {"a.jpg", jpeg(20000, 5001)},
                                                           {"a.webp", webp(20000, 5001)},
                                                           {"a.bmp", bmp(20000, 5001)},
                                                           {"a.tga", tga(20000, 5001)}};
    for (const auto& [name, bytes] : headers) {
        EXPECT_EQ(reason(name, bytes), "it has 20000 x 5001 pixels, more than 100 million");
    }
    EXPECT_EQ(reason("a.png", png(0, 5001)), "it has no pixels");
    EXPECT_EQ(reason("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 20000 +X 5001\n"),
              "it has 5001 x 20000 pixels, more than 100 million");
}

TEST_F(Images, MorePixelsThanItsBytesCanHoldAreRefused) {
    EXPECT_EQ(reason("a.png", png(5000, 5000)),
              "it declares 5000 x 5000 pixels, more than its 45 bytes can contain");
    EXPECT_EQ(reason("a.jpg", jpeg(5000, 5000)),
              "it declares 5000 x 5000 pixels, more than its 21 bytes can contain");
    EXPECT_EQ(reason("a.tga", tga(5000, 5000)),
              "it declares 5000 x 5000 pixels, more than its 18 bytes can contain");
}

// Sanitizers take address space of their own. Of this name, it runs before the others, which leave
// memory that is free.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(EncodingDeathTest, SaysThatMemoryIsMissing) {
    std::mt19937 random(1);
    std::vector<std::uint8_t> noise(std::size_t{2000} * 2000 * 3);
    std::generate(noise.begin(), noise.end(), [&] { return static_cast<std::uint8_t>(random()); });
    const Raster raster{2000, 2000, 3, noise};
    const auto encode_in_little_memory = [&] {
        std::size_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        // The file has 12 MB, for which memory is taken in steps that double.
        const rlim_t most = pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) + 20'000'000;
        const rlimit limit{most, most};
        const bool is_limited = ::setrlimit(RLIMIT_AS, &limit) == 0;
        const auto made = encode(raster, "png");
        const bool is_said =
            !made && made.diagnostics.front().message ==
                         "the picture cannot be encoded as png: there is not enough memory";
        std::_Exit(is_limited && is_said ? 0 : 1);
    };
    EXPECT_EXIT(encode_in_little_memory(), ::testing::ExitedWithCode(0), "");
}
#endif

TEST_F(Images, AnAttributeLongerThanItsExrFileIsRefused) {
    const auto attribute = [](const std::string& name, std::size_t claimed) {
        return name + '\0' + "string" + '\0' + little_endian(claimed, 4) + "text";
    };
    const std::string end(1, '\0');
    const std::string one_part = "\x76\x2f\x31\x01" + little_endian(2, 4);
    const std::string several_parts = "\x76\x2f\x31\x01" + little_endian(0x1002, 4);
    const std::string good = attribute("a", 4);
    const std::string damaged = "it is truncated or corrupt";
    for (const std::size_t claimed : {6UL, 0x7fffffffUL, 0xffffffffUL}) {
        const std::string bad = attribute("b", claimed);
        for (const std::string& bytes :
             {one_part + good + bad + end, several_parts + good + end + good + bad + end + end,
              one_part + std::string(1000, 'c'), one_part + good}) {
            EXPECT_EQ(reason("a.exr", bytes), damaged) << claimed;
        }
    }
    // What is left is OpenEXR's to judge: these have no pixels.
    for (const std::string& bytes :
         {one_part + good + end, several_parts + good + end + good + end + end}) {
        EXPECT_NE(reason("a.exr", bytes), damaged);
        EXPECT_NE(reason("a.exr", bytes), "opened");
    }
}

TEST_F(Images, ACutOrDamagedPngIsRecognised) {
    const std::vector<std::uint8_t> samples(std::size_t{width} * height * 3, 77);
    const auto whole = encode({width, height, 3, std::span<const std::uint8_t>(samples)}, "png");
    ASSERT_TRUE(whole);
    constexpr std::size_t header_end = 33;
    constexpr std::string_view name = "IDAT";
    constexpr std::size_t length_size = 4;
    // Damage to what says how colours are meant, before the pixels, and to the checksum of the last
    // chunk, which is empty, does not matter.
    constexpr std::size_t checksum_size = 4;
    const auto pixels_at = static_cast<std::size_t>(
        std::search(whole->begin(), whole->end(), name.begin(), name.end()) - whole->begin());
    for (std::size_t size = header_end; size < whole->size(); ++size) {
        EXPECT_EQ(reason(ImageFile::open("cut.png", std::span(*whole).first(size))),
                  "it is truncated or corrupt");
        std::vector<std::uint8_t> changed = *whole;
        changed[size] ^= 4U;
        const auto opened = ImageFile::open("changed.png", changed);
        std::vector<std::uint8_t> rows(samples.size());
        const bool is_refused = !opened || (*opened)->read_rows(0, height, rows);
        EXPECT_TRUE(is_refused || size + length_size < pixels_at ||
                    size + checksum_size >= whole->size())
            << size;
    }
    EXPECT_EQ(reason(ImageFile::open("whole.png", *whole)), "opened");
}

TEST_F(Images, ACutTiffIsRecognised) {
    const std::vector<std::uint8_t> whole = bytes_of(image("image.tif"));
    constexpr std::size_t signature = 4;
    for (std::size_t size = signature; size < whole.size(); ++size) {
        const auto file = ImageFile::open("cut.tif", std::span(whole).first(size));
        if (file) {
            // The pixels alone may stand behind the directory.
            std::vector<float> rows((*file)->height() * (*file)->width() * (*file)->channels());
            EXPECT_TRUE((*file)->read_rows(0, (*file)->height(), rows)) << size;
        } else {
            EXPECT_EQ(reason(file), "it is truncated or corrupt") << size;
        }
    }
    EXPECT_EQ(reason(ImageFile::open("whole.tif", whole)), "opened");
}

// The directory of a BigTIFF, and of one whose numbers begin with their highest byte.
TEST_F(Images, ATiffWhoseValuesAreBeyondItsEndIsRefused) {
    using namespace std::string_literals;
    const std::string damaged = "it is truncated or corrupt";
    const std::string big_tiff = "II+\0\x08\0\0\0"s + little_endian(16, 8) + little_endian(1, 8) +
                                 little_endian(258, 2) + little_endian(3, 2) + little_endian(5, 8);
    EXPECT_EQ(reason("a.tif", big_tiff + little_endian(35, 8)), damaged);
    EXPECT_NE(reason("a.tif", big_tiff + little_endian(34, 8)), damaged);
    const std::string reversed = "MM\0*\0\0\0\x08\0\x01\x01\x02\0\x03\0\0\0\x03\0\0\0"s;
    EXPECT_EQ(reason("a.tif", reversed + '\x11'), damaged);
    EXPECT_NE(reason("a.tif", reversed + '\x10'), damaged);
}

TEST_F(Images, TilesBeyondReasonAreRefused) {
    // The width of a tile is one tag of the directory, which is where the number 16 stands twice.
    std::vector<std::uint8_t> bytes = bytes_of(image("tiled.tif", 16));
    const auto set_tag = [&](unsigned tag, std::uint32_t value) {
        for (std::size_t i = 0; i + 12 <= bytes.size(); ++i) {
            if (bytes[i] == (tag & 0xffU) && bytes[i + 1] == tag >> 8U && bytes[i + 3] == 0 &&
                (bytes[i + 2] == 3 || bytes[i + 2] == 4) && bytes[i + 4] == 1) {
                bytes[i + 2] = 4;
                for (unsigned k = 0; k < 4; ++k) {
                    bytes[i + 8 + k] = static_cast<std::uint8_t>(value >> (8 * k));
                }
            }
        }
    };
    constexpr unsigned tile_width = 322;
    constexpr unsigned tile_length = 323;
    set_tag(tile_width, 1U << 20U);
    set_tag(tile_length, 1U << 20U);
    EXPECT_EQ(reason(ImageFile::open("tiled.tif", bytes)),
              "its tiles of 1048576 x 1048576 pixels are too large");
}

// For any bytes, an image is opened and read, or there is an error with a reason.
TEST_F(Images, ChangedBytesDoNoHarm) {
    std::mt19937 random(7);
    for (const std::string ending : endings) {
        const std::vector<std::uint8_t> whole = bytes_of(image("image." + ending));
        std::size_t opened_count = 0;
        std::size_t read_count = 0;
        for (int i = 0; i < 200; ++i) {
            std::vector<std::uint8_t> bytes = whole;
            // Half of the changes go to the header.
            const std::size_t reach =
                i % 2 == 0 ? std::min<std::size_t>(64, bytes.size()) : bytes.size();
            for (auto changes = 1 + random() % 4; changes > 0; --changes) {
                bytes[random() % reach] = static_cast<std::uint8_t>(random() % 256);
            }
            auto opened = ImageFile::open("image." + ending, bytes);
            if (!opened) {
                EXPECT_TRUE(has_errors(opened.diagnostics));
                continue;
            }
            ++opened_count;
            const std::size_t rows = std::min<std::size_t>((*opened)->height(), 64);
            std::vector<float> values(rows * (*opened)->width() * (*opened)->channels());
            read_count += (*opened)->read_rows(0, rows, values) ? 0 : 1;
        }
        EXPECT_GT(opened_count, 20U) << ending;
        // The checksums of PNG find every change, except of what says how colours are meant.
        EXPECT_TRUE(ending != "png" || read_count < 20) << read_count;
    }
}

}  // namespace balcony::images::testing::image_file_test
