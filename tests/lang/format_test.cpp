// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include <gtest/gtest.h>

#include "lang/lexer.hpp"
#include "support.hpp"

namespace balcony::lang {

namespace {

std::shared_ptr<const SourceText> source(std::string text) {
    return std::make_shared<const SourceText>("test.cam", std::move(text));
}

std::string formatted(const std::string& text) {
    const Result<std::string> made = format(source(text));
    return made ? *made : to_text(made.diagnostics);
}

// The words of a text and its comments, each without the spaces around it.
std::vector<std::string> words(const std::string& text) {
    const auto read = source(text);
    Reporter reporter;
    const Tokens tokens = tokenize(read, reporter);
    std::vector<std::string> made;
    for (const Token& token : tokens.tokens) {
        made.emplace_back(read->text().substr(token.span.begin, token.span.end - token.span.begin));
    }
    for (const Span& comment : tokens.comments) {
        made.emplace_back(read->text().substr(comment.begin, comment.end - comment.begin));
        made.back().erase(made.back().find_last_not_of(" \t\r") + 1);
    }
    return made;
}

std::vector<std::filesystem::path> camera_files() {
    std::vector<std::filesystem::path> files;
    for (const char* folder : {"cameras", "plates", "tests/lang"}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(
                 std::filesystem::path(BALCONY_SOURCE_DIR) / folder)) {
            if (entry.path().extension() == ".cam") {
                files.push_back(entry.path());
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

TEST(Format, PutsOneStatementOnALineAndAlignsArguments) {
    EXPECT_EQ(
        formatted("camera a(R=10,r = 2){map u=90deg..0deg,v=-180deg .. 180deg eye circle( R )\n"
                  "toward torus(R,r)move rotate(x,30deg),translate(0,-14,3)}"),
        "camera a(R = 10, r = 2) {\n"
        "    map    u = 90deg .. 0deg, v = -180deg .. 180deg\n"
        "    eye    circle(R)\n"
        "    toward torus(R, r)\n"
        "    move   rotate(x, 30deg), translate(0, -14, 3)\n"
        "}\n");
}

TEST(Format, WritesProductsTightAndSumsWithSpaces) {
    EXPECT_EQ(formatted("let a=1+2 *3 - -4^ 2/ 5\nlet b = !( a<2&&a >=-1 )"),
              "let a = 1 + 2*3 - -4^2/5\nlet b = !(a < 2 && a >= -1)\n");
}

TEST(Format, KeepsCommentsWhereTheyBelong) {
    const std::string text =
        "// Above.\n"
        "camera a {  // Behind the head.\n"
        "    // On a line of its own.\n"
        "    map u = 0 .. 1, v = 0 .. 1  // Behind a statement.\n"
        "    eye plane(at = (0, 0, 0),  // In the middle.\n"
        "              along_u = (1, 0, 0))\n"
        "    /* Before the end. */\n"
        "}\n"
        "\n"
        "// At the end.\n";
    EXPECT_EQ(formatted(text), text);
}

TEST(Format, KeepsSingleBlankLinesAndPartsCameras) {
    EXPECT_EQ(formatted("import \"pinhole.cam\"\n\n\nlet a = 1\ncamera b {\n\n    eye sphere\n\n\n"
                        "    map u = 0 .. 1, v = 0 .. a\n\n}\ncamera c { eye plane }\n"),
              "import \"pinhole.cam\"\n"
              "\n"
              "let a = 1\n"
              "\n"
              "camera b {\n"
              "    eye sphere\n"
              "\n"
              "    map u = 0 .. 1, v = 0 .. a\n"
              "}\n"
              "\n"
              "camera c {\n"
              "    eye plane\n"
              "}\n");
}

TEST(Format, BreaksLongLinesBehindCommas) {
    const std::string text =
        "camera a {\n"
        "    eye product(superellipse(1, 0.5555555555, 0.25, by = arc_length),\n"
        "                superellipse(45, 25.5555555555, 0.25, by = arc_length))\n"
        "}\n";
    EXPECT_EQ(formatted("camera a { eye product(superellipse(1,0.5555555555,0.25,by=arc_length),"
                        "superellipse(45,25.5555555555,0.25,by=arc_length))}"),
              text);
}

TEST(Format, KeepsTheRowsOfAList) {
    const std::string text =
        "camera a {\n"
        "    warp grid([(0, 0), (0, 0),\n"
        "               (0, 1), (1, 1)], columns = 2)\n"
        "}\n";
    EXPECT_EQ(formatted(text), text);
    EXPECT_EQ(formatted("camera a { warp grid([(0, 0), (0,\n0),\n(0, 1), (1, 1)],\ncolumns = 2) }"),
              text);
}

TEST(Format, BreaksLongSumsBeforeAnOperator) {
    std::string sum = "let a = 1";
    for (int i = 0; i < 30; ++i) {
        sum += " + 1000000";
    }
    const std::string made = formatted(sum);
    EXPECT_EQ(words(made), words(sum));
    std::size_t begin = 0;
    for (std::size_t end = made.find('\n'); end != std::string::npos;
         end = made.find('\n', begin)) {
        EXPECT_LE(end - begin, 100U);
        begin = end + 1;
    }
}

TEST(Format, LeavesTextsWithSyntaxErrorsAlone) {
    const auto made = format(source("camera a { map u = }"));
    EXPECT_FALSE(made);
    EXPECT_TRUE(has_errors(made.diagnostics));
}

class FormatsFile : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(FormatsFile, KeepingEveryWordAndThenChangingNothing) {
    const std::string text = test::read_file(GetParam());
    const Result<std::string> made = format(source(text));
    if (!made) {
        EXPECT_NE(GetParam().string().find("bad"), std::string::npos) << to_text(made.diagnostics);
        return;
    }
    EXPECT_EQ(words(*made), words(text));
    EXPECT_EQ(formatted(*made), *made);
}

// What comes along shows the layout.
TEST_P(FormatsFile, AsItIsIfItIsShipped) {
    if (GetParam().string().find("tests/lang") == std::string::npos) {
        const std::string text = test::read_file(GetParam());
        EXPECT_EQ(formatted(text), text) << "run: balcony fmt " << GetParam();
    }
}

INSTANTIATE_TEST_SUITE_P(All, FormatsFile, testing::ValuesIn(camera_files()), [](const auto& file) {
    std::string name =
        file.param.parent_path().filename().string() + "_" + file.param.stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
    return name;
});

}  // namespace balcony::lang
