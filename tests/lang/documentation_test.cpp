// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Every ```cam snippet of docs/ is a file without errors or warnings.

#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"
#include "small_image.hpp"
#include "support.hpp"

namespace balcony::lang::documentation_test {
namespace {

// The first block of a page that begins with a line.
std::string block(const std::string& text, const std::string& opening) {
    const std::size_t begin = text.find(opening) + opening.size();
    return text.substr(begin, text.find("```", begin) - begin);
}

// How many snippets a page has; each is tried.
std::size_t try_snippets(const std::filesystem::path& page) {
    const std::string text = test::read_file(page);
    const std::string opening = "```cam\n";
    const std::string calibration =
        block(test::read_file(BALCONY_SOURCE_DIR "/docs/calibrated.md"), "```yaml\n");
    std::size_t count = 0;
    for (std::size_t at = text.find(opening); at != std::string::npos;
         at = text.find(opening, at)) {
        at += opening.size();
        const files::TemporaryFolder folder;
        folder.write("lengths.cam", "let room_length = 9");
        folder.write("calibration.yml", calibration);
        folder.write("camchain.yml",
                     "cam0:\n  camera_model: pinhole\n  intrinsics: [460, 460, 370, 240]\n"
                     "  distortion_model: radtan\n  distortion_coeffs: [0, 0, 0, 0]\n"
                     "  resolution: [752, 480]\n");
        folder.write("plain.yml", "K: [620, 620, 800, 600]\nD: [0, 0, 0, 0]\n");
        folder.write("mix.tga", test::four_greys());
        const std::string snippet = text.substr(at, text.find("```", at) - at);
        EXPECT_EQ(to_text(test::check(folder.write("snippet.cam", snippet))), "")
            << page << snippet;
        ++count;
    }
    return count;
}

TEST(Documentation, EverySnippetWorks) {
    const std::filesystem::path docs = BALCONY_SOURCE_DIR "/docs";
    for (const auto& page : std::filesystem::directory_iterator(docs)) {
        if (page.path().extension() == ".md") {
            (void)try_snippets(page.path());
        }
    }
    EXPECT_GE(try_snippets(docs / "language.md"), 12U);
    EXPECT_EQ(try_snippets(docs / "tutorial.md"), 7U);
}

// What the page about C++ quotes stands in the examples, which another test builds and runs; the
// first of them is there as a whole.
TEST(Documentation, ListingsOfCppAreTheExamples) {
    const std::filesystem::path root = BALCONY_SOURCE_DIR;
    const std::string page = test::read_file(root / "docs/cpp.md");
    const std::string rays = test::read_file(root / "examples/rays/main.cpp");
    const std::string programs = rays + test::read_file(root / "examples/own_stage/main.cpp") +
                                 test::read_file(root / "examples/render/main.cpp") +
                                 test::read_file(root / "examples/solve/main.cpp");
    const std::string opening = "```cpp\n";
    std::size_t count = 0;
    for (std::size_t at = page.find(opening); at != std::string::npos;
         at = page.find(opening, at)) {
        at += opening.size();
        const std::string snippet = page.substr(at, page.find("```", at) - at);
        EXPECT_NE(programs.find(snippet), std::string::npos) << snippet;
        ++count;
    }
    EXPECT_EQ(count, 11U);
    EXPECT_NE(page.find(rays.substr(rays.find("#include"))), std::string::npos);
    EXPECT_NE(page.find(test::read_file(root / "examples/rays/CMakeLists.txt")), std::string::npos);
}

}  // namespace
}  // namespace balcony::lang::documentation_test
