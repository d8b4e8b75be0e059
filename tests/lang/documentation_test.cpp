// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Every ```cam snippet of docs/language.md is a file without errors or warnings.

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::lang {
namespace {

TEST(Documentation, EverySnippetWorks) {
    const std::string text = test::read_file(BALCONY_SOURCE_DIR "/docs/language.md");
    const std::string opening = "```cam\n";
    std::size_t count = 0;
    for (std::size_t at = text.find(opening); at != std::string::npos;
         at = text.find(opening, at)) {
        at += opening.size();
        const test::TemporaryFolder folder;
        folder.write("lengths.cam", "let room_length = 9");
        const std::string snippet = text.substr(at, text.find("```", at) - at);
        EXPECT_EQ(to_text(check(folder.write("snippet.cam", snippet))), "") << snippet;
        ++count;
    }
    EXPECT_GE(count, 12U);
}

}  // namespace
}  // namespace balcony::lang
