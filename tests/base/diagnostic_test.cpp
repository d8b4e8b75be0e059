// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "balcony/base.hpp"

namespace balcony::diagnostic_test {
namespace {

// A span over the first occurrence of a part in a text.
SourceSpan span_of(const std::string& text, const std::string& part) {
    const auto source = std::make_shared<const SourceText>("a.cam", text);
    const std::size_t begin = source->text().find(part);
    return {source, begin, begin + part.size()};
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

std::size_t code_points(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
    }));
}

// What stands above the underline, column by column: the text that the user sees marked.
std::string marked(const Diagnostic& diagnostic) {
    const std::vector<std::string> lines = lines_of(to_text(diagnostic));
    const std::string& excerpt = lines.at(1);
    const std::string& underline = lines.at(2);
    std::string part;
    std::size_t column = 0;
    const std::size_t first = underline.find('^');
    for (const char c : excerpt) {
        column += code_points({&c, 1});
        if (column > first && column <= underline.size()) {
            part += c;
        }
    }
    return part;
}

TEST(Diagnostic, ShowsThePlaceTheLineTheMarkAndTheRemedy) {
    const std::string text = "camera a {\n    eye superelipse(1, 2)\n}\n";
    const Diagnostic diagnostic =
        error("there is no stage named 'superelipse'", span_of(text, "superelipse"),
              "did you mean 'superellipse'?");
    EXPECT_EQ(to_text(diagnostic),
              "a.cam:2:9: error: there is no stage named 'superelipse'\n"
              "    2 |     eye superelipse(1, 2)\n"
              "      |         ^~~~~~~~~~~\n"
              "  help: did you mean 'superellipse'?\n");
}

TEST(Diagnostic, WithoutASourceIsOneLine) {
    EXPECT_EQ(to_text(error("no such file 'a.cam'")), "error: no such file 'a.cam'\n");
    EXPECT_EQ(to_text(warning("odd", {}, "look again")), "warning: odd\n  help: look again\n");
}

TEST(Diagnostic, NotesShowTheirOwnPlaces) {
    const std::string text = "camera a {}\ncamera b {}\n";
    Diagnostic diagnostic = warning("second", span_of(text, "b"));
    diagnostic.notes.push_back({span_of(text, "a {"), "first"});
    diagnostic.notes.push_back({{}, "nowhere"});
    EXPECT_EQ(to_text(diagnostic),
              "a.cam:2:8: warning: second\n"
              "    2 | camera b {}\n"
              "      |        ^\n"
              "a.cam:1:8: note: first\n"
              "    1 | camera a {}\n"
              "      |        ^~~\n"
              "note: nowhere\n");
}

TEST(Diagnostic, SeveralComeOneAfterTheOther) {
    const Diagnostics both = {warning("one"), error("two")};
    EXPECT_EQ(to_text(both), "warning: one\nerror: two\n");
    EXPECT_TRUE(has_errors(both));
    EXPECT_FALSE(has_errors({warning("one")}));
    EXPECT_FALSE(has_errors({}));
}

TEST(Diagnostic, TheKindOfSeveralIsThatOfTheFirstError) {
    const Diagnostic full = error(Kind::environment, "the disk is full", "make room");
    EXPECT_EQ(full.remedy, "make room");
    EXPECT_EQ(kind_of_errors({warning("one"), full, error("two")}), Kind::environment);
    EXPECT_EQ(kind_of_errors({error("two"), full}), Kind::input);
    EXPECT_EQ(kind_of_errors({warning("one")}), std::nullopt);
}

TEST(Diagnostic, EachKindHasItsName) {
    EXPECT_EQ(name_of(Kind::input), "input");
    EXPECT_EQ(name_of(Kind::usage), "usage");
    EXPECT_EQ(name_of(Kind::environment), "environment");
    EXPECT_EQ(name_of(Kind::interrupted), "interrupted");
    EXPECT_EQ(name_of(Kind::internal), "internal");
}

TEST(Diagnostic, TheMarkIsBelowItsTextAfterWideBytes) {
    const std::string text = "\u03b3 = \u03b1\u03b2 + \u20ac\U0001d11e wrong\n";
    EXPECT_EQ(marked(error("x", span_of(text, "wrong"))), "wrong");
    EXPECT_EQ(marked(error("x", span_of(text, "\u03b1\u03b2"))), "\u03b1\u03b2");
}

TEST(Diagnostic, TheMarkIsBelowItsTextAfterTabs) {
    const std::string text = "\t\teye\twrong\n";
    EXPECT_EQ(marked(error("x", span_of(text, "wrong"))), "wrong");
    EXPECT_EQ(to_text(error("x", span_of(text, "wrong"))).find('\t'), std::string::npos);
}

TEST(Diagnostic, TheMarkStaysBelowItsTextAtLargeLineNumbers) {
    const std::string text = std::string(1234567, '\n') + "  wrong";
    EXPECT_EQ(marked(error("x", span_of(text, "wrong"))), "wrong");
}

TEST(Diagnostic, AnEmptySpanIsMarkedByOneColumn) {
    const auto source = std::make_shared<const SourceText>("a.cam", "one\n");
    EXPECT_EQ(to_text(error("x", {source, 3, 3})),
              "a.cam:1:4: error: x\n    1 | one\n      |    ^\n");
    EXPECT_EQ(to_text(error("x", {source, 4, 4})), "a.cam:2:1: error: x\n    2 | \n      | ^\n");
}

TEST(Diagnostic, ASpanOverLinesIsMarkedToTheEndOfItsFirst) {
    EXPECT_EQ(marked(error("x", span_of("a = [1,\n 2]\n", "[1,\n 2]"))), "[1,");
    EXPECT_EQ(marked(error("x", span_of("a = [1,\r\n 2]\r\n", "[1,\r\n 2]"))), "[1,");
}

TEST(Diagnostic, OfALongLineAWindowIsShown) {
    const std::string text = std::string(3000, 'a') + "wrong" + std::string(3000, 'b');
    const Diagnostic diagnostic = error("x", span_of(text, "wrong"));
    EXPECT_EQ(marked(diagnostic), "wrong");
    const std::string excerpt = lines_of(to_text(diagnostic)).at(1);
    EXPECT_LT(excerpt.size(), 120U);
    EXPECT_TRUE(excerpt.starts_with("    1 | ...a"));
    EXPECT_TRUE(excerpt.ends_with("b..."));
}

TEST(Diagnostic, AWindowDoesNotCutACharacter) {
    for (const std::size_t shift : {0U, 1U, 2U}) {
        std::string text(shift, 'x');
        for (int i = 0; i < 200; ++i) {
            text += "\u20ac";
        }
        const auto source = std::make_shared<const SourceText>("a.cam", text);
        const std::size_t begin = shift + std::size_t{3} * 100;
        const Diagnostic diagnostic = error("x", {source, begin, begin + 3});
        EXPECT_EQ(to_text(diagnostic).find('?'), std::string::npos);
        EXPECT_EQ(marked(diagnostic), "\u20ac");
    }
}

TEST(Diagnostic, ASpanInsideACharacterMarksTheWholeOfIt) {
    const auto source = std::make_shared<const SourceText>("a.cam", "a\u20acb");
    EXPECT_EQ(lines_of(to_text(error("x", {source, 2, 3}))).at(1), "    1 | a\u20acb");
    EXPECT_EQ(marked(error("x", {source, 2, 3})), "\u20ac");
}

// Escape sequences, C1 controls (also as two bytes, and as overlong forms that a lax terminal would
// decode), marks that reverse the reading direction, bytes that are no UTF-8.
TEST(Diagnostic, NothingInTheSourceControlsTheTerminal) {
    const std::vector<std::string> hostile = {"\x1b[2J",
                                              std::string("\0", 1),
                                              "\x7f",
                                              "\xc2\x9b"
                                              "31m",
                                              "\xc0\x9b",
                                              "\xe0\x80\x9b",
                                              "\u202e",
                                              "\u2066",
                                              "\xff",
                                              "\x80\x80",
                                              "\xed\xa0\x80",
                                              "\xf5\x80\x80\x80",
                                              "\r"};
    for (const std::string& bytes : hostile) {
        const std::string text = "a" + bytes + "wrong";
        const std::string shown = to_text(error("x", span_of(text, "wrong")));
        EXPECT_NE(shown.find('?'), std::string::npos) << shown;
        EXPECT_EQ(shown.find(bytes), std::string::npos);
        EXPECT_EQ(marked(error("x", span_of(text, "wrong"))), "wrong");
    }
}

TEST(Diagnostic, NothingInAMessageControlsTheTerminal) {
    const auto source = std::make_shared<const SourceText>("a\x1b.cam", "a");
    Diagnostic diagnostic = error("bad name '\x1b'", {source, 0, 1}, "not '\x1b'");
    diagnostic.notes.push_back({{}, "nor '\x1b'"});
    const std::string shown = to_text(diagnostic);
    EXPECT_EQ(shown.find('\x1b'), std::string::npos);
    EXPECT_EQ(std::count(shown.begin(), shown.end(), '?'), 4);
}

// Whatever the bytes and wherever the span, there is an excerpt of two lines, and the mark lies
// within it.
TEST(Diagnostic, AnyBytesAndAnySpanCanBeShown) {
    std::mt19937 random(1);
    const auto below = [&random](std::size_t bound) { return random() % bound; };
    for (int round = 0; round < 3000; ++round) {
        std::string text(below(300), '\0');
        for (char& c : text) {
            c = static_cast<char>(below(8) == 0 ? '\n' : below(256));
        }
        const auto source = std::make_shared<const SourceText>("a.cam", text);
        const Diagnostic diagnostic = error("x", {source, below(320), below(320)});
        const std::vector<std::string> lines = lines_of(to_text(diagnostic));
        ASSERT_EQ(lines.size(), 3U);
        ASSERT_EQ(std::count(lines[2].begin(), lines[2].end(), '^'), 1);
        ASSERT_LE(lines[2].size(), code_points(lines[1]) + 1);
    }
}

}  // namespace
}  // namespace balcony::diagnostic_test
