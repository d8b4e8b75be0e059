// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Every file bad/NN-name.cam has its exact diagnostics in bad/NN-name.expected.
// After a change of messages, BALCONY_WRITE_EXPECTED=1 lang_test rewrites the expected files;
// read each difference before it is committed.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "../files/temporary_folder.hpp"
#include "support.hpp"

namespace balcony::lang::bad_files_test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> bad_files() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(BALCONY_BAD_FILES)) {
        if (entry.path().extension() == ".cam") {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

// The messages with file names in the place of paths.
std::string said_of(const fs::path& file) {
    std::string text = to_text(test::check(file));
    for (const std::string_view path : {BALCONY_BAD_FILES "/", BALCONY_BAD_FILES}) {
        for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path, at)) {
            text.replace(at, path.size(), path.ends_with('/') ? "" : "bad");
        }
    }
    return text;
}

class BadFile : public testing::TestWithParam<fs::path> {};

TEST_P(BadFile, HasTheExpectedDiagnostics) {
    const fs::path expected_file = fs::path(GetParam()).replace_extension(".expected");
    const std::string said = said_of(GetParam());
    EXPECT_FALSE(said.empty());
    if (std::getenv("BALCONY_WRITE_EXPECTED") != nullptr) {
        std::ofstream(expected_file, std::ios::binary) << said;
    }
    EXPECT_EQ(said, test::read_file(expected_file));
}

TEST_P(BadFile, HasAWayOutOfEachError) {
    for (const Diagnostic& said : test::check(GetParam())) {
        const bool is_sum = said.message.starts_with("there are more errors");
        EXPECT_TRUE(said.severity != Severity::error || !said.remedy.empty() || is_sum)
            << to_text({said});
    }
}

INSTANTIATE_TEST_SUITE_P(All, BadFile, testing::ValuesIn(bad_files()), [](const auto& file) {
    std::string name = file.param.stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
    return name;
});

std::string name(int i) { return test::joined({"a", std::to_string(i)}); }

std::string let(int i, std::string_view value) {
    return test::joined({"let ", name(i), " = ", value, "\n"});
}

// Files that do not belong in a repository.

TEST(GeneratedBadFile, FiftyMegabytesAreRefusedUnread) {
    const files::TemporaryFolder folder;
    const fs::path file = folder.write("large.cam", "");
    fs::resize_file(file, 50'000'000);
    EXPECT_EQ(to_text(test::check(file)),
              test::joined({"error: '", file.string(),
                            "' is larger than 1 MB, the maximum for camera files\n"
                            "  help: check that it is a camera file\n"}));
}

TEST(GeneratedBadFile, ZeroBytesGiveOneError) {
    const files::TemporaryFolder folder;
    const fs::path file =
        folder.write("binary.cam", test::joined({"camera a {", std::string(5000, '\0')}));
    const Diagnostics said = test::check(file);
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(said[0].message,
              test::joined({"'", file.string(), "' is not a text file: its byte 11 is zero"}));
}

TEST(GeneratedBadFile, RubbishGivesOneError) {
    const files::TemporaryFolder folder;
    std::string rubbish;
    for (int i = 0; i < 10000; ++i) {
        rubbish += static_cast<char>(i * 37 % 255 + 1);
    }
    EXPECT_EQ(test::check(folder.write("rubbish.cam", rubbish)).size(), 1U);
}

TEST(GeneratedBadFile, AFolderIsNoFile) {
    const files::TemporaryFolder folder;
    const Diagnostics said = test::check(folder.path());
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(said[0].message,
              test::joined({"'", folder.path().string(), "' is a folder, not a file"}));
}

TEST(GeneratedBadFile, ADeviceIsNeverRead) {
    const files::TemporaryFolder folder;
    const fs::path file = folder.write("device.cam", "import \"/dev/zero\"\n");
    const Diagnostics said = test::check(file);
    ASSERT_FALSE(said.empty());
    EXPECT_EQ(said[0].message, "'/dev/zero' is a pipe or a device, not a file");
    EXPECT_TRUE(said[0].span.source);
}

TEST(GeneratedBadFile, NoLineOfAnotherKindOfFileIsShown) {
    const files::TemporaryFolder folder;
    folder.write("secrets", "root:x:0:0:secret\nname = secret\n");
    const Diagnostics said = test::check(folder.write("a.cam", "import \"secrets\"\n"));
    ASSERT_FALSE(said.empty());
    EXPECT_NE(said[0].message.find("is not a camera file"), std::string::npos);
    EXPECT_EQ(to_text(said).find("secret\n"), std::string::npos) << to_text(said);
}

TEST(GeneratedBadFile, NestingIsBounded) {
    for (const char* bracket : {"(", "-", "2^", "sin(", "if(1, 2, "}) {
        std::string text = "let a = ";
        for (int i = 0; i < 20000; ++i) {
            text += bracket;
        }
        const Result<camera::Camera> made = test::make(text);
        ASSERT_FALSE(made) << bracket;
        EXPECT_EQ(made.diagnostics.size(), 1U) << to_text(made.diagnostics);
    }
}

TEST(GeneratedBadFile, ChainsOfIndicesAreBounded) {
    std::string chain;
    for (int i = 0; i < 300'000; ++i) {
        chain += "[0]";
    }
    const Diagnostics said =
        test::make(test::joined({"let a = [(1, 2)]\nlet b = a", chain})).diagnostics;
    ASSERT_EQ(said.size(), 1U) << to_text(said);
    EXPECT_EQ(said[0].message, "a value has more than 16 indices");
}

// The header says a name too much, and all names in it are lost.
TEST(GeneratedBadFile, ABrokenHeaderIsOneError) {
    const Diagnostics said =
        test::make(
            "camera fisheye fisheye(fov = 180deg, px = 0) {\n fit px = scene_radius\n"
            " map u = fov/2 .. -fov/2, v = square\n eye sphere(1)\n move translate(px, 0, 0)\n}")
            .diagnostics;
    ASSERT_EQ(said.size(), 1U) << to_text(said);
    EXPECT_EQ(said[0].message, "the name of a camera is one word");
}

TEST(GeneratedBadFile, LongChainsNeedNoStack) {
    std::string sum = "let a = 1";
    for (int i = 0; i < 100'000; ++i) {
        sum += " + t";
    }
    constexpr int last = 20'000;
    std::string chain;
    std::string circle = let(0, name(last));
    for (int i = last; i > 0; --i) {
        chain += let(i, test::joined({name(i - 1), " + t"}));
        circle += let(i, name(i - 1));
    }
    chain += let(0, "1");
    const std::string camera = "\ncamera c { map u = 0 .. 1, v = square eye sphere(1) }";
    EXPECT_TRUE(test::make(sum + camera));
    EXPECT_TRUE(test::make(chain + camera));
    EXPECT_EQ(test::make(circle + camera).diagnostics.size(), 1U);
}

TEST(GeneratedBadFile, ErrorsAreCountedUpToABound) {
    std::string text;
    for (int i = 0; i < 100; ++i) {
        text += let(i, test::joined({"nothing_", name(i)}));
    }
    const Diagnostics said = test::make(text).diagnostics;
    ASSERT_EQ(said.size(), 21U);
    EXPECT_EQ(said.back().message, "there are more errors; only the first 20 are shown");
}

// Where reading ends for too many errors, the built-in cameras are not read either.
TEST(GeneratedBadFile, PicturesOfStandardCamerasMayFollowAnyNumberOfErrors) {
    for (int errors = 0; errors < 30; ++errors) {
        std::string lets;
        std::string blends;
        for (int i = 0; i < errors; ++i) {
            lets += let(i, "nothing");
            blends += "blend no" + name(i) + "\n";
        }
        for (const std::string& text :
             {lets + "picture p { layer fisheye }",
              test::joined({"picture p {\nlayer pinhole {\n", blends, "}\n layer fisheye\n}"})}) {
            const auto source = std::make_shared<const SourceText>("test.cam", text);
            const Result<camera::Picture> made = make_picture(source, "", {});
            EXPECT_EQ(made.value.has_value(), errors == 0) << text;
            EXPECT_EQ(has_errors(made.diagnostics), errors > 0) << text;
        }
    }
}

}  // namespace
}  // namespace balcony::lang::bad_files_test
