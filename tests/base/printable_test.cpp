// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <random>

#include <gtest/gtest.h>

#include "balcony/base.hpp"

namespace balcony::printable_test {
namespace {

TEST(Printable, TextIsUnchanged) {
    for (const char* text : {"", "wall", "Wände, стены, 壁", "e\u0301", "\U0001d11e", "\u00a0",
                             "\u200a", "\u2027", "\u202f", "\u205f", "\u2070", "\ufffd"}) {
        EXPECT_EQ(printable(text), text);
    }
}

TEST(Printable, InvalidTextBecomesAQuestionMark) {
    for (const char* text :
         {"\x1b",   "\x7f",   "\a",         "\r",     "\u0085", "\u009b", "\u00ad",
          "\u061c", "\u180e", "\u200b",     "\u200d", "\u200e", "\u200f", "\u2028",
          "\u2029", "\u202a", "\u202e",     "\u2060", "\u2066", "\u2069", "\u206f",
          "\ufeff", "\ufff9", "\U000e0041", "\xff",   "\x80"}) {
        EXPECT_EQ(printable(std::string("a") + text + "b"), "a?b");
    }
    EXPECT_EQ(printable(std::string_view("\0", 1)), "?");
    // Of an overlong form, a surrogate and a number too large each byte is one.
    EXPECT_EQ(printable("\xc0\x9b"), "??");
    EXPECT_EQ(printable("\xed\xa0\x80"), "???");
    EXPECT_EQ(printable("\xf5\x80\x80\x80"), "????");
    EXPECT_EQ(printable("\xe2\x80"), "??");
}

TEST(Printable, LineFeedsAreKeptOnRequest) {
    EXPECT_EQ(printable("a\tb\nc"), "a b?c");
    EXPECT_EQ(printable("a\tb\nc", LineFeeds::keep), "a b\nc");
    EXPECT_EQ(printable("a\r\nb", LineFeeds::keep), "a?\nb");
}

// For any bytes, a second call replaces nothing.
TEST(Printable, IsIdempotent) {
    std::mt19937 random(1);
    for (int round = 0; round < 2000; ++round) {
        std::string text(random() % 60, '\0');
        for (char& c : text) {
            c = static_cast<char>(random() % 256);
        }
        const std::string once = printable(text, LineFeeds::keep);
        EXPECT_EQ(printable(once, LineFeeds::keep), once);
    }
}

}  // namespace
}  // namespace balcony::printable_test
