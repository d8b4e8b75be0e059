// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include <gtest/gtest.h>

#include "lang/syntax/lexer.hpp"
#include "support.hpp"

namespace balcony::lang::format_test {

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

// The lines of a text, without their ends.
std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> made;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        made.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return made;
}

// A camera whose statement `eye    plane(label = "...", side = 1)` is `width` columns wide, written
// in letters of two bytes each.
std::string camera_of_width(std::size_t width, const std::string& rest = "") {
    const std::string begin = "    eye plane(label = \"";
    const std::string end = "\", side = 1)";
    std::string letters;
    for (std::size_t i = begin.size() + end.size(); i < width; ++i) {
        letters += "\u00e4";
    }
    return "camera a {\n" + begin + letters + end + rest + "\n}\n";
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

// A lens is written as a call, or as a stage of another name behind the word.
TEST(Format, KnowsBothFormsOfALens) {
    const std::string text =
        "camera a {\n    lens(radius = 1, focus = 2)\n}\n\ncamera b {\n"
        "    lens table(\"dgauss.dat\", focus = 2)\n}\n";
    EXPECT_EQ(formatted(text), text);
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
    const std::vector<std::string> rows = lines(made);
    ASSERT_GT(rows.size(), 3U);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_LE(rows[i].size(), 100U);
        if (i > 0) {
            EXPECT_TRUE(rows[i].starts_with("    + 1")) << rows[i];
        }
    }
}

TEST(Format, KeepsALineOf100LettersWhole) {
    const std::string full = camera_of_width(100);
    EXPECT_EQ(formatted(full), full);
    const std::vector<std::string> broken = lines(formatted(camera_of_width(101)));
    ASSERT_EQ(broken.size(), 4U);
    EXPECT_EQ(broken[2], "              side = 1)");
}

TEST(Format, LeavesCommentsBehindLongLines) {
    // The comma is the last letter that fits.
    const std::string line = "    eye plane(label = \"" + std::string(75, 'a') + "\",";
    ASSERT_EQ(line.size(), 100U);
    const std::string text = "camera a {\n" + line + "  // Why.\n              side = 1)\n}\n";
    EXPECT_EQ(formatted(text), text);
    const std::string behind = camera_of_width(100, "  // Behind a full line.");
    EXPECT_EQ(formatted(behind), behind);
}

TEST(Format, FillsLinesUpToTheElementThatDoesNotFit) {
    // The third argument fits into the first line, regardless of the text after it.
    const std::string first =
        "    eye product(superellipse(1, 2, 0.25), superellipse(1, 2, 0.25), scale(1, (2, 3)),";
    const std::string second = "                superellipse(45, 25.5, 0.25))";
    const std::string text = "camera a {\n" + first + "\n" + second + "\n}\n";
    EXPECT_EQ(formatted(text), text);
}

TEST(Format, WritesKeywordsWithASpaceAndCallsWithout) {
    EXPECT_EQ(formatted("camera a { aspect-1 }"), "camera a {\n    aspect -1\n}\n");
    EXPECT_EQ(formatted("camera a { aspect(1+2)/3 }"), "camera a {\n    aspect (1 + 2)/3\n}\n");
    EXPECT_EQ(formatted("picture p { layer a { frame (width=0.02) place(0,0) .. (1,1) } }"),
              "picture p {\n"
              "    layer a {\n"
              "        frame(width = 0.02)\n"
              "        place (0, 0) .. (1, 1)\n"
              "    }\n"
              "}\n");
}

TEST(Format, LeavesOutBlanksBehindComments) {
    EXPECT_EQ(formatted("// One. \t\r\nlet a = 1  // Two.  \n"), "// One.\nlet a = 1  // Two.\n");
}

TEST(Format, KeepsCommentsInTheMiddleOfAStatement) {
    const std::string text =
        "camera a {\n"
        "    eye  /* which? */ plane(at = (0, 0, 0),\n"
        "                            // On a line of its own.\n"
        "                            along_u = (1, 0, 0))\n"
        "}\n";
    EXPECT_EQ(formatted(text), text);
}

TEST(Format, AlignsArgumentsAcrossComments) {
    const std::string text =
        "camera a {\n"
        "    eye    plane\n"
        "    // The next word is longer.\n"
        "    toward sphere\n"
        "\n"
        "    map u = 0 .. 1, v = 0 .. 1\n"
        "}\n";
    EXPECT_EQ(formatted(text), text);
}

TEST(Format, DoesNotChangeTextsWithSyntaxErrors) {
    const auto made = format(source("camera a { map u = }"));
    EXPECT_FALSE(made);
    EXPECT_TRUE(has_errors(made.diagnostics));
}

TEST(Format, RejectsResultsThatAreTooLargeToRead) {
    // The rows of the list stand below one another: each takes 73 bytes.
    const auto laid_out = [](int rows) {
        std::string text = "let " + std::string(62, 'a') + " = [0";
        for (int i = 1; i < rows; ++i) {
            text += ",\n0";
        }
        return format(source(text + "]\n"));
    };
    EXPECT_TRUE(laid_out(1'000'000 / 73 - 1));
    const auto made = laid_out(1'000'000 / 73 + 2);
    ASSERT_FALSE(made);
    ASSERT_EQ(made.diagnostics.size(), 1U);
    EXPECT_EQ(
        made.diagnostics[0].message,
        "'test.cam' would be larger than 1 MB after formatting, the maximum for camera files");
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

// The built-in cameras are in the standard layout.
TEST_P(FormatsFile, UnchangedIfBuiltIn) {
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

}  // namespace balcony::lang::format_test
