// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "balcony/base.hpp"

namespace balcony::source_text_test {
namespace {

void expect_place(const SourceText& source, std::size_t offset, std::size_t line,
                  std::size_t column) {
    const LineColumn place = source.locate(offset);
    EXPECT_EQ(place.line, line) << "at offset " << offset;
    EXPECT_EQ(place.column, column) << "at offset " << offset;
}

TEST(SourceText, CountsLinesAndColumnsFromOne) {
    const SourceText source("a.cam", "one\ntwo\n\nfour");
    EXPECT_EQ(source.line_count(), 4U);
    expect_place(source, 0, 1, 1);
    expect_place(source, 2, 1, 3);
    expect_place(source, 4, 2, 1);
    expect_place(source, 8, 3, 1);
    expect_place(source, 12, 4, 4);
}

TEST(SourceText, ALineBreakBelongsToTheLineItEnds) {
    const SourceText source("a.cam", "one\ntwo");
    expect_place(source, 3, 1, 4);
}

TEST(SourceText, AnOffsetPastTheEndIsClamped) {
    const SourceText source("a.cam", "one\ntwo");
    expect_place(source, 7, 2, 4);
    expect_place(source, 1000, 2, 4);
    expect_place(SourceText("empty", ""), 5, 1, 1);
}

TEST(SourceText, ATextThatEndsInALineBreakHasAnEmptyLastLine) {
    const SourceText source("a.cam", "one\n");
    EXPECT_EQ(source.line_count(), 2U);
    EXPECT_EQ(source.line(2), "");
    expect_place(source, 4, 2, 1);
}

TEST(SourceText, ColumnsAreCodePoints) {
    // Greek gamma takes two bytes, the euro sign three, the clef four.
    const SourceText source("a.cam", "\u03b3\u20ac\U0001d11ex");
    expect_place(source, 2, 1, 2);
    expect_place(source, 5, 1, 3);
    expect_place(source, 9, 1, 4);
}

TEST(SourceText, LinesComeWithoutTheirBreaks) {
    const SourceText source("a.cam", "unix\nwindows\r\nlast");
    EXPECT_EQ(source.line(1), "unix");
    EXPECT_EQ(source.line(2), "windows");
    EXPECT_EQ(source.line(3), "last");
    expect_place(source, 14, 3, 1);
}

TEST(SourceText, DropsAByteOrderMark) {
    const SourceText source("a.cam",
                            "\xef\xbb\xbf"
                            "camera\n");
    EXPECT_EQ(source.line(1), "camera");
    expect_place(source, 0, 1, 1);
    expect_place(source, 7, 2, 1);
}

TEST(SourceSpan, JoinHoldsBothInEitherOrder) {
    const auto source = std::make_shared<const SourceText>("a.cam", "0123456789");
    const SourceSpan early{source, 1, 3};
    const SourceSpan late{source, 6, 8};
    for (const SourceSpan& joined : {join(early, late), join(late, early)}) {
        EXPECT_EQ(joined.source, source);
        EXPECT_EQ(joined.begin, 1U);
        EXPECT_EQ(joined.end, 8U);
    }
}

}  // namespace
}  // namespace balcony::source_text_test
